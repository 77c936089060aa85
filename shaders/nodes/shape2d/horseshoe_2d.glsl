// Horseshoe 2D: A curved bar with straight arms and square ends, open at the bottom.
// field: bound
// synonyms: magnet, u shape, omega, arch
float horseshoe_2d_distance(
    vec2 p,
    float radius,     // 0.4 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of the bar.
    float aperture,   // 200.0 [20, 300] deg  Angle of the curved part.
    float arm,        // 0.3 [0, 100] [0, 5] m  Length of the straight arms.
    float thickness)  // 0.2 [0.001, 100] [0.01, 2] m  Width of the bar.
{
    vec2 outwards = vec2(sin(0.5f * aperture), cos(0.5f * aperture));
    vec2 q = vec2(abs(p.x), p.y);
    float along = q.x * outwards.y - q.y * outwards.x;
    float distance_out = along > 0.0f ? dot(q, outwards) : length(q);
    vec2 beyond = vec2(along - arm, abs(distance_out - radius) - 0.5f * thickness);
    return length(max(beyond, vec2(0.0f))) + min(max(beyond.x, beyond.y), 0.0f);
}

Box horseshoe_2d_bounds(float radius, float arm, float thickness)
{
    float reach = length(vec2(radius + 0.5f * thickness, arm));
    return make_box(vec3(0.0f), vec3(reach, reach, 0.0f));
}
