// Rounded rectangle: A rectangle whose corners are rounded off within its size.
// field: exact
// synonyms: round rectangle, stadium, button
float rounded_rectangle_distance(
    vec2 p,
    vec2 half_size,  // (0.5, 0.3) [0.001, 100] [0.05, 5] m  Half the width and half the height, rounding included.
    float rounding)  // 0.1 [0, 50] [0, 1] m  Radius of the corners, at most half the shorter side.
{
    float corner = min(rounding, min(half_size.x, half_size.y));
    vec2 q = abs(p) - (half_size - vec2(corner));
    return length(max(q, vec2(0.0f))) + min(max(q.x, q.y), 0.0f) - corner;
}

Box rounded_rectangle_bounds(vec2 half_size)
{
    return make_box(vec3(0.0f), vec3(half_size.x, half_size.y, 0.0f));
}
