// View: the camera of a viewport, which is nobody's node.

// Unit vectors, and how far rays at the picture's upper edge lie off the middle: slope in the direction, half_height in
// the origin (m). One of the two is 0: a perspective view or an orthographic one. Of the vectors that a target and an up
// make, the renderer finds these: once per picture, and with a tangent that takes long to compile.
struct Viewpoint {
    vec3 position;
    vec3 forward;
    vec3 right;
    vec3 upward;
    float slope;
    float half_height;
};

Ray view_ray(vec2 uv, Viewpoint view)
{
    vec3 aside = uv.x * view.right + uv.y * view.upward;
    Ray ray;
    ray.origin = view.position + view.half_height * aside;
    ray.direction = normalize(view.forward + view.slope * aside);
    ray.forward = view.forward;
    ray.right = view.right;
    return ray;
}
