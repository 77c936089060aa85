// Ring: A circular band.
// field: exact; bound
// synonyms: annulus, washer, band
float ring_distance(
    vec2 p,
    float radius,     // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of the band.
    float thickness)  // 0.15 [0.001, 100] [0.01, 2] m  Width of the band.
{
    return abs(length(p) - radius) - 0.5f * thickness;
}

Box ring_bounds(float radius, float thickness)
{
    float reach = radius + 0.5f * thickness;
    return make_box(vec3(0.0f), vec3(reach, reach, 0.0f));
}
