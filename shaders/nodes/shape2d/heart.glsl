// Heart: A heart of two half circles over a square corner.
// field: exact
// synonyms: love, valentine, cards
float heart_distance(
    vec2 p,
    float size)  // 1.0 [0.001, 200] [0.1, 10] m  Height from the tip to the top.
{
    float unit = size * 0.90618860f;
    vec2 q = vec2(abs(p.x), p.y + 0.5f * size) / unit;
    vec2 from_lobe = vec2(q.x - 0.25f, q.y - 0.75f);
    vec2 from_dent = vec2(q.x, q.y - 1.0f);
    float along = 0.5f * max(q.x + q.y, 0.0f);
    vec2 from_edge = vec2(q.x - along, q.y - along);
    float outline = sqrt(min(dot(from_dent, from_dent), dot(from_edge, from_edge)));
    float signed_outline = q.x > q.y ? outline : -outline;
    return unit * (q.x + q.y > 1.0f ? length(from_lobe) - 0.35355339f : signed_outline);
}

Box heart_bounds(float size)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(0.54697f * size, 0.5f * size, 0.0f));
}
