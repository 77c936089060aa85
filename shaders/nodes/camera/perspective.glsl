// Perspective: A camera that sees like an eye: what is far away is small.
// synonyms: camera, lens, view, eye, depth of field, bokeh, aperture, focus
Ray perspective_ray(
    vec2 uv,
    vec2 lens,
    vec3 position,         // (4, 3, 6) [-10000, 10000] [-10, 10] m  Where the camera is.
    vec3 target,           // (0, 0, 0) [-10000, 10000] [-10, 10] m  Where it looks.
    float field_of_view,   // 45.0 [1, 170] [10, 120] deg  Angle from the lower to the upper edge of the picture.
    float aperture,        // 0.0 [0, 100] [0, 0.5] m  Diameter of the lens: the larger, the softer what is out of focus; 0 keeps all of it sharp.
    float focus_distance)  // 7.8 [0.001, 10000] [0.1, 20] m  How far in front of the camera things are sharp.
{
    vec3 way = target - position;
    float far_away = length(way);
    vec3 forward = far_away > 1.0e-6f ? way / max(far_away, 1.0e-6f) : vec3(0.0f, 0.0f, -1.0f);
    // Straight up or down there is no level direction across the view; x serves.
    float level = length(vec2(forward.x, forward.z));
    float safe = max(level, 1.0e-5f);
    vec3 right = level > 1.0e-5f ? vec3(-forward.z / safe, 0.0f, forward.x / safe) : vec3(1.0f, 0.0f, 0.0f);
    vec3 upward = cross(right, forward);
    float slope = tan(0.5f * field_of_view);
    // Rays of one pixel meet in the plane of focus, wherever they cross the lens.
    vec2 across = 0.5f * aperture * lens;
    vec2 spread = slope * uv - across / focus_distance;
    Ray ray;
    ray.origin = position + right * across.x + upward * across.y;
    ray.direction = normalize(forward + right * spread.x + upward * spread.y);
    ray.forward = forward;
    ray.right = right;
    return ray;
}
