// Custom 2D shape: a rounded rectangle, yours to change.
// field: exact
float custom_profile_distance(
    vec2 p,
    vec2 size,        // (0.6, 0.4) [0.01, 100] [0.1, 2] m  Half the width and height, without the rounding.
    float roundness)  // 0.1 [0, 10] [0, 0.5] m  Radius of the corners.
{
    vec2 q = abs(p) - size;
    return length(max(q, vec2(0.0f))) + min(max(q.x, q.y), 0.0f) - roundness;
}

// A box around the outline; its depth is not looked at.
Box custom_profile_bounds(vec2 size, float roundness)
{
    return make_box(vec3(0.0f), vec3(size.x + roundness, size.y + roundness, 0.0f));
}
