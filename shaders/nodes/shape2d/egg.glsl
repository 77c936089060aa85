// Egg: An egg with its pointed end on top.
// field: exact
// synonyms: oval, ovoid
float egg_distance(
    vec2 p,
    float bottom_radius,  // 0.4 [0.001, 100] [0.05, 5] m  Radius of the wide end.
    float top_radius)     // 0.15 [0, 100] [0, 5] m  Radius of the pointed end, at most that of the wide end.
{
    float top = min(top_radius, bottom_radius);
    float step_in = bottom_radius - top;
    vec2 q = vec2(abs(p.x), p.y + 0.3660254f * step_in);
    float rise = 1.73205081f * step_in;
    float to_bottom = length(q) - step_in;
    float to_top = length(vec2(q.x, q.y - rise));
    float to_side = length(vec2(q.x + step_in, q.y)) - 2.0f * step_in;
    bool above = 1.73205081f * (q.x + step_in) < q.y;
    return (q.y < 0.0f ? to_bottom : (above ? to_top : to_side)) - top;
}

Box egg_bounds(float bottom_radius, float top_radius)
{
    float step_in = bottom_radius - min(top_radius, bottom_radius);
    float half_height = bottom_radius + 0.3660254f * step_in;
    return make_box(vec3(0.0f), vec3(bottom_radius, half_height, 0.0f));
}
