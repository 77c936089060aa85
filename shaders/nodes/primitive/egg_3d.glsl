// Egg 3D: An egg that stands on its thick end.
// field: exact
// synonyms: easter egg, ovoid, oval
float egg_3d_distance(
    vec3 p,
    float radius,      // 0.7 [0.001, 100] [0.05, 5] m  Radius of the thick end.
    float tip_radius)  // 0.2 [0, 100] [0, 5] m  Radius of the thin end, at most that of the thick one.
{
    float tip = min(tip_radius, radius);
    float thick = radius - tip;
    float lift = 1.73205081f * thick;
    // The middle stands at the origin.
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y + 0.5f * lift - 0.5f * thick);
    float to_thick = length(q) - thick;
    float to_tip = length(vec2(q.x, q.y - lift));
    float to_flank = length(vec2(q.x + thick, q.y)) - 2.0f * thick;
    return (q.y < 0.0f ? to_thick : 1.73205081f * (q.x + thick) < q.y ? to_tip : to_flank) - tip;
}

Box egg_3d_bounds(float radius, float tip_radius)
{
    float tip = min(tip_radius, radius);
    float thick = radius - tip;
    float half_height = 0.5f * (2.73205081f * thick) + tip;
    return make_box(vec3(0.0f), vec3(radius, half_height, radius));
}
