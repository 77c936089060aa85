// Swirl: Stirs a solid around the y axis: the closer to the axis, the farther it turns.
// field: bound
// synonyms: vortex, whirl, stir, twirl, spiral
vec3 swirl_point(
    vec3 p,
    float angle,   // 120.0 [-3600, 3600] [-360, 360] deg  Turn at the axis.
    float radius)  // 1.5 [0.01, 1000] [0.1, 5] m  Distance from the axis where the turn ends.
{
    float rest = 1.0f - min((p.x * p.x + p.z * p.z) / (radius * radius), 1.0f);
    float turn = angle * rest * rest;
    return vec3(p.x * cos(turn) + p.z * sin(turn), p.y, p.z * cos(turn) - p.x * sin(turn));
}

// A shear whose slope, the change of the turn times the distance from the axis, never exceeds the turn itself.
float swirl_stretch(float angle)
{
    float slope = abs(angle);
    return 0.5f * (slope + sqrt(slope * slope + 4.0f));
}

Box swirl_bounds(Box child)
{
    float reach =
        length(vec2(abs(child.centre.x) + child.half_size.x, abs(child.centre.z) + child.half_size.z)) * 1.000001f;
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(reach, child.half_size.y, reach));
}
