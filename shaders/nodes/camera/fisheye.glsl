// Fisheye: A camera that sees a half sphere or more: distance from the picture's middle is the angle from its axis.
// synonyms: camera, equidistant, dome, planetarium, wide angle
// Half of what it sees may lie behind it, so its depth is the distance from the camera.
Ray fisheye_ray(
    vec2 uv,
    vec3 position,        // (4, 3, 6) [-10000, 10000] [-10, 10] m  Where the camera is.
    vec3 target,          // (0, 0, 0) [-10000, 10000] [-10, 10] m  Where it looks.
    float field_of_view)  // 180.0 [1, 360] [60, 360] deg  Angle from the lower to the upper edge of the picture.
{
    vec3 way = target - position;
    float far_away = length(way);
    vec3 forward = far_away > 1.0e-6f ? way / max(far_away, 1.0e-6f) : vec3(0.0f, 0.0f, -1.0f);
    // Straight up or down there is no level direction across the view; x serves.
    float level = length(vec2(forward.x, forward.z));
    float safe = max(level, 1.0e-5f);
    vec3 right = level > 1.0e-5f ? vec3(-forward.z / safe, 0.0f, forward.x / safe) : vec3(1.0f, 0.0f, 0.0f);
    vec3 upward = cross(right, forward);
    float outward = length(uv);
    float angle = min(0.5f * field_of_view * outward, 3.1415926f);
    float sideways = sin(angle) / max(outward, 1.0e-6f);
    Ray ray;
    ray.origin = position;
    ray.direction = normalize(cos(angle) * forward + sideways * (uv.x * right + uv.y * upward));
    ray.forward = ray.direction;
    ray.right = right;
    return ray;
}
