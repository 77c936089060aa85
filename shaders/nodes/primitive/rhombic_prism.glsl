// Rhombic prism: A column along the y axis with the outline of a rhombus.
// field: exact
// synonyms: rhombus, diamond prism, lozenge, tile
// Squared distance from q to a segment of the plane.
float rhombic_prism_edge(vec2 q, vec2 start, vec2 finish)
{
    vec2 along = finish - start;
    vec2 from_start = q - start;
    vec2 away = from_start - along * clamp(dot(from_start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
    return dot(away, away);
}

float rhombic_prism_distance(
    vec3 p,
    float half_width,  // 0.8 [0.001, 100] [0.05, 5] m  Distance from the axis to the edges along x.
    float half_depth,  // 0.35 [0.001, 100] [0.05, 5] m  Distance from the axis to the edges along z.
    float height)      // 0.6 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    vec2 q = abs(vec2(p.x, p.z));
    float outline = sqrt(rhombic_prism_edge(q, vec2(half_width, 0.0f), vec2(0.0f, half_depth)));
    float side = q.x * half_depth + q.y * half_width < half_width * half_depth ? -outline : outline;
    float cap = abs(p.y) - 0.5f * height;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box rhombic_prism_bounds(float half_width, float half_depth, float height)
{
    return make_box(vec3(0.0f), vec3(half_width, 0.5f * height, half_depth));
}
