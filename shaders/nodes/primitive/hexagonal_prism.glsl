// Hexagonal prism: A six-sided column along the y axis, such as a nut or a honeycomb cell.
// field: exact
// synonyms: hexagon, hex prism, nut, honeycomb
float hexagonal_prism_distance(
    vec3 p,
    float radius,  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the axis to the flat sides.
    float height)  // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    vec2 mirror_normal = vec2(-0.8660254f, 0.5f);
    vec2 q = abs(vec2(p.x, p.z));
    q = q - mirror_normal * (2.0f * min(dot(mirror_normal, q), 0.0f));
    float half_side = 0.57735027f * radius;
    float outline = length(vec2(q.x - clamp(q.x, -half_side, half_side), q.y - radius));
    float side = q.y < radius ? -outline : outline;
    float cap = abs(p.y) - 0.5f * height;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box hexagonal_prism_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(1.1547006f * radius, 0.5f * height, radius));
}
