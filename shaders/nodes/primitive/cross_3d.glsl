// Cross 3D: Three square bars along the axes that meet in the middle.
// field: exact; bound
// synonyms: jack, plus, axes, barricade
float cross_3d_distance(
    vec3 p,
    float half_length,  // 0.8 [0.001, 100] [0.05, 5] m  Distance from the centre to the ends of the bars.
    float thickness)    // 0.4 [0.001, 100] [0.05, 2] m  Width of the bars.
{
    vec3 q = abs(p);
    float most = max(q.x, max(q.y, q.z));
    float least = min(q.x, min(q.y, q.z));
    float between = max(min(q.x, q.y), min(max(q.x, q.y), q.z));
    float bar = 0.5f * thickness;
    vec3 beyond = vec3(most - max(half_length, bar), between - bar, least - bar);
    return length(max(beyond, vec3(0.0f))) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0f);
}

Box cross_3d_bounds(float half_length, float thickness)
{
    return make_box(vec3(0.0f), vec3(max(half_length, 0.5f * thickness)));
}
