// Triangular prism: A three-sided bar along the z axis with one edge on top.
// field: exact
// synonyms: triangle, tent, wedge, roof
float triangular_prism_distance(
    vec3 p,
    float radius,  // 0.6 [0.001, 100] [0.05, 5] m  Distance from the axis to the three edges.
    float depth)   // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    vec2 mirror_normal = vec2(0.5f, 0.8660254f);
    vec2 q = vec2(abs(p.x), p.y);
    q = q - mirror_normal * (2.0f * max(dot(mirror_normal, q), 0.0f));
    float half_side = 0.8660254f * radius;
    float below = -q.y - 0.5f * radius;
    float outline = length(vec2(q.x - clamp(q.x, -half_side, half_side), below));
    float side = below < 0.0f ? -outline : outline;
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box triangular_prism_bounds(float radius, float depth)
{
    return make_box(vec3(0.0f, 0.25f * radius, 0.0f), vec3(0.8660254f * radius, 0.75f * radius, 0.5f * depth));
}
