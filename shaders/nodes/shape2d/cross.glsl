// Cross: Two crossed bars with square ends.
// field: exact
// synonyms: plus, swiss cross, add
float cross_distance(
    vec2 p,
    float half_size,  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the ends.
    float thickness)  // 0.3 [0.001, 200] [0.01, 2] m  Width of the bars, at most the length of them.
{
    float half_bar = min(0.5f * thickness, half_size);
    vec2 q = vec2(max(abs(p.x), abs(p.y)), min(abs(p.x), abs(p.y)));
    vec2 beyond = vec2(q.x - half_size, q.y - half_bar);
    float to_dent = length(max(vec2(half_bar) - q, vec2(0.0f)));
    return max(beyond.x, beyond.y) > 0.0f ? length(max(beyond, vec2(0.0f))) : -min(to_dent, -beyond.x);
}

Box cross_bounds(float half_size)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_size, half_size, 0.0f));
}
