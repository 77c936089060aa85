// Hexagon: A regular hexagon with a flat top.
// field: exact
// synonyms: hex, six sides, honeycomb, nut
float hexagon_distance(
    vec2 p,
    float radius)  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of a side.
{
    vec2 q = abs(p);
    float fold = 2.0f * min(0.5f * q.y - 0.8660254f * q.x, 0.0f);
    vec2 r = vec2(q.x + 0.8660254f * fold, q.y - 0.5f * fold);
    float half_side = radius * 0.57735027f;
    float outline = length(vec2(r.x - clamp(r.x, -half_side, half_side), r.y - radius));
    return r.y < radius ? -outline : outline;
}

Box hexagon_bounds(float radius)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(1.15470054f * radius, radius, 0.0f));
}
