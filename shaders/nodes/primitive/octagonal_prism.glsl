// Octagonal prism: An eight-sided column along the y axis.
// field: exact
// synonyms: octagon, stop sign, eight-sided
float octagonal_prism_distance(
    vec3 p,
    float radius,  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the axis to the flat sides.
    float height)  // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    vec2 mirror_normal = vec2(-0.38268343f, 0.92387953f);
    vec2 flat_place = abs(vec2(p.x, p.z));
    vec2 q = vec2(max(flat_place.x, flat_place.y), min(flat_place.x, flat_place.y));
    q = q - mirror_normal * (2.0f * max(dot(mirror_normal, q), 0.0f));
    float half_side = 0.41421356f * radius;
    float beyond = q.x - radius;
    float outline = length(vec2(beyond, q.y - clamp(q.y, -half_side, half_side)));
    float side = beyond < 0.0f ? beyond : outline;
    float cap = abs(p.y) - 0.5f * height;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box octagonal_prism_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height, radius));
}
