// Equal angle: A camera whose pixels are equal steps of angle, across and up: the middle is large, as in a wide panorama.
// synonyms: camera, equiangular, panorama, wide angle
Ray equal_angle_ray(
    vec2 uv,
    vec3 position,        // (4, 3, 6) [-10000, 10000] [-10, 10] m  Where the camera is.
    vec3 target,          // (0, 0, 0) [-10000, 10000] [-10, 10] m  Where it looks.
    float field_of_view)  // 60.0 [1, 170] [10, 120] deg  Angle from the lower to the upper edge of the picture; across it ends at 89 degrees to either side.
{
    vec3 way = target - position;
    float far_away = length(way);
    vec3 forward = far_away > 1.0e-6f ? way / max(far_away, 1.0e-6f) : vec3(0.0f, 0.0f, -1.0f);
    // Straight up or down there is no level direction across the view; x serves.
    float level = length(vec2(forward.x, forward.z));
    float safe = max(level, 1.0e-5f);
    vec3 right = level > 1.0e-5f ? vec3(-forward.z / safe, 0.0f, forward.x / safe) : vec3(1.0f, 0.0f, 0.0f);
    vec3 upward = cross(right, forward);
    float limit = 1.5533f;  // 89 degrees
    float across = clamp(0.5f * field_of_view * uv.x, -limit, limit);
    float up = clamp(0.5f * field_of_view * uv.y, -limit, limit);
    Ray ray;
    ray.origin = position;
    ray.direction = normalize(forward + right * tan(across) + upward * tan(up));
    ray.forward = forward;
    ray.right = right;
    return ray;
}
