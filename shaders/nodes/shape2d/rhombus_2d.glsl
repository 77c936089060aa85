// Rhombus 2D: A diamond with its corners on the axes.
// field: exact
// synonyms: diamond, lozenge, kite
float rhombus_2d_distance(
    vec2 p,
    float half_width,   // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the corners left and right.
    float half_height)  // 0.35 [0.001, 100] [0.05, 5] m  Distance from the centre to the corners above and below.
{
    vec2 edge = vec2(-half_width, half_height);
    vec2 q = vec2(abs(p.x) - half_width, abs(p.y));
    vec2 away = q - edge * clamp(dot(q, edge) / dot(edge, edge), 0.0f, 1.0f);
    return edge.x * q.y - edge.y * q.x > 0.0f ? -length(away) : length(away);
}

Box rhombus_2d_bounds(float half_width, float half_height)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_width, half_height, 0.0f));
}
