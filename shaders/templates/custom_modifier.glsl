// Custom modifier: bumps on a surface, yours to change.
// field: approximate 0.7
float custom_modifier_distance(
    vec3 p,
    float d,
    float depth,      // 0.03 [0, 1] [0, 0.1] m  Height of the bumps.
    float frequency)  // 12.0 [0, 100] [1, 30] 1/m  How close they are.
{
    return d + depth * sin(frequency * p.x) * sin(frequency * p.y) * sin(frequency * p.z);
}

// A box around the surface; child is the one of the input.
Box custom_modifier_bounds(float depth, Box child)
{
    return make_box(child.centre, child.half_size + vec3(depth));
}
