// Trapezoid: A symmetric quadrilateral with a bottom and a top of different widths.
// field: exact
// synonyms: trapezium, bucket, keystone
float trapezoid_distance(
    vec2 p,
    float half_bottom,  // 0.5 [0, 100] [0, 5] m  Half the width at the bottom.
    float half_top,     // 0.3 [0, 100] [0, 5] m  Half the width at the top.
    float half_height)  // 0.35 [0.001, 100] [0.05, 5] m  Half the height.
{
    vec2 q = vec2(abs(p.x), p.y);
    vec2 side = vec2(half_top - half_bottom, 2.0f * half_height);
    vec2 from_corner = vec2(q.x - half_bottom, q.y + half_height);
    vec2 from_side = from_corner - side * clamp(dot(from_corner, side) / dot(side, side), 0.0f, 1.0f);
    float beyond = abs(q.y) - half_height;
    vec2 from_end = vec2(max(q.x - (q.y < 0.0f ? half_bottom : half_top), 0.0f), beyond);
    float outline = sqrt(min(dot(from_side, from_side), dot(from_end, from_end)));
    return side.x * from_corner.y - side.y * from_corner.x > 0.0f && beyond < 0.0f ? -outline : outline;
}

Box trapezoid_bounds(float half_bottom, float half_top, float half_height)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(max(half_bottom, half_top), half_height, 0.0f));
}
