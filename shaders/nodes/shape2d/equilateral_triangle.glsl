// Equilateral triangle: A triangle of three equal sides with one corner on top.
// field: exact
// synonyms: regular triangle, three sides, delta
float equilateral_triangle_distance(
    vec2 p,
    float side)  // 1.0 [0.001, 200] [0.1, 10] m  Length of a side.
{
    float half_side = 0.5f * side;
    float x = abs(p.x) - half_side;
    float y = p.y + half_side * 0.57735027f;
    bool beyond = x + 1.73205081f * y > 0.0f;
    vec2 q = beyond ? vec2(0.5f * x - 0.8660254f * y, -0.8660254f * x - 0.5f * y) : vec2(x, y);
    float outline = length(vec2(q.x - clamp(q.x, -side, 0.0f), q.y));
    return q.y > 0.0f ? -outline : outline;
}

Box equilateral_triangle_bounds(float side)
{
    return make_box(vec3(0.0f, 0.14433757f * side, 0.0f), vec3(0.5f * side, 0.43301270f * side, 0.0f));
}
