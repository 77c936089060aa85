// Orthographic: A camera with parallel rays: what is far away is as large as what is near.
// synonyms: camera, parallel, isometric, plan, elevation
Ray orthographic_ray(
    vec2 uv,
    vec3 position,  // (4, 3, 6) [-10000, 10000] [-10, 10] m  Where the camera is.
    vec3 target,    // (0, 0, 0) [-10000, 10000] [-10, 10] m  Where it looks.
    float height)   // 4.0 [0.001, 10000] [0.1, 20] m  Height of the part of the scene that the picture shows.
{
    vec3 way = target - position;
    float far_away = length(way);
    vec3 forward = far_away > 1.0e-6f ? way / max(far_away, 1.0e-6f) : vec3(0.0f, 0.0f, -1.0f);
    // Straight up or down there is no level direction across the view; x serves.
    float level = length(vec2(forward.x, forward.z));
    float safe = max(level, 1.0e-5f);
    vec3 right = level > 1.0e-5f ? vec3(-forward.z / safe, 0.0f, forward.x / safe) : vec3(1.0f, 0.0f, 0.0f);
    vec3 upward = cross(right, forward);
    Ray ray;
    ray.origin = position + right * (0.5f * height * uv.x) + upward * (0.5f * height * uv.y);
    ray.direction = forward;
    ray.forward = forward;
    ray.right = right;
    return ray;
}
