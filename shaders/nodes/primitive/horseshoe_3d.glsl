// Horseshoe 3D: A square bar bent to a half circle with two straight legs, such as a magnet.
// field: exact; bound
// synonyms: magnet, u shape, arch, staple, shackle
float horseshoe_3d_distance(
    vec3 p,
    float radius,  // 0.5 [0.001, 100] [0.05, 5] m  Radius of the half circle, to the middle of the bar.
    float leg,     // 0.6 [0, 100] [0, 5] m  Length of the straight legs.
    float width,   // 0.25 [0.001, 50] [0.01, 2] m  Width of the bar in the plane of the bend, at most twice the radius.
    float depth)   // 0.3 [0.001, 200] [0.05, 5] m  Width of the bar along z.
{
    vec2 q = vec2(abs(p.x), p.y - 0.5f * (leg - radius));
    float across = abs((q.y > 0.0f ? length(q) : q.x) - radius) - min(0.5f * width, radius);
    vec3 beyond = vec3(across, -q.y - leg, abs(p.z) - 0.5f * depth);
    return length(max(beyond, vec3(0.0f))) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0f);
}

Box horseshoe_3d_bounds(float radius, float leg, float width, float depth)
{
    float reach = radius + min(0.5f * width, radius);
    float rise = reach - radius;
    return make_box(vec3(0.0f, 0.5f * rise, 0.0f), vec3(reach, 0.5f * (leg + radius + rise), 0.5f * depth));
}
