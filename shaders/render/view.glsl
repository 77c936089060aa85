// View: the camera of a viewport, which is nobody's node.

// orthographic_height: of the part of the scene that the picture shows, in metres; 0 is a perspective view.
struct ViewCamera {
    vec3 position;
    vec3 target;
    vec3 up;
    float field_of_view;
    float orthographic_height;
};

Ray view_ray(vec2 uv, ViewCamera camera)
{
    vec3 way = camera.target - camera.position;
    float far_away = length(way);
    vec3 forward = far_away > 1.0e-6f ? way / max(far_away, 1.0e-6f) : vec3(0.0f, 0.0f, -1.0f);
    // Along `up` there is no level direction across the view; x serves.
    vec3 level = cross(forward, camera.up);
    float levelness = length(level);
    vec3 right = levelness > 1.0e-5f ? level / max(levelness, 1.0e-5f) : vec3(1.0f, 0.0f, 0.0f);
    vec3 upward = cross(right, forward);
    float slope = tan(0.5f * camera.field_of_view);
    vec3 spread = right * (uv.x * slope) + upward * (uv.y * slope);
    vec3 shift = right * (0.5f * camera.orthographic_height * uv.x) + upward * (0.5f * camera.orthographic_height * uv.y);
    bool parallel = camera.orthographic_height > 0.0f;
    Ray ray;
    ray.origin = camera.position + shift;
    ray.direction = parallel ? forward : normalize(forward + spread);
    ray.forward = forward;
    ray.right = right;
    return ray;
}
