// Moon: A crescent, a disc without the part that another disc covers.
// The cutting disc is kept across the outline, so that there is always a crescent.
// field: exact
// synonyms: crescent, lune, sickle, banana
float moon_distance(
    vec2 p,
    float radius,      // 0.6 [0.001, 100] [0.05, 5] m  Radius of the disc.
    float cut_radius,  // 0.5 [0.001, 100] [0.05, 5] m  Radius of the disc that is cut away.
    float offset)      // 0.35 [0.001, 200] [0.05, 5] m  How far to the right the cut lies.
{
    float apart = max(offset, 0.05f * radius);
    float cut = clamp(cut_radius, abs(radius - apart) + 0.05f * radius, radius + apart - 0.05f * radius);
    float tip_x = 0.5f * (apart + (radius - cut) * (radius + cut) / apart);
    float tip_y = sqrt(max(radius * radius - tip_x * tip_x, 0.0f));
    vec2 q = vec2(p.x, abs(p.y));
    float to_tip = length(vec2(q.x - tip_x, q.y - tip_y));
    float to_outer = length(q) - radius;
    float to_inner = cut - length(vec2(q.x - apart, q.y));
    float within = max(to_outer, to_inner);
    // Beyond both rays from the centres through the tip.
    bool beyond_outer = q.x * tip_y > q.y * tip_x;
    bool beyond_inner = (q.x - apart) * tip_y > q.y * (tip_x - apart);
    return within > 0.0f && beyond_outer && beyond_inner ? to_tip : within;
}

Box moon_bounds(float radius)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(radius, radius, 0.0f));
}
