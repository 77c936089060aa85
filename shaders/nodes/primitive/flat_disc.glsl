// Flat disc: A thin round plate with a round edge.
// field: exact
// synonyms: coin, plate, wafer, counter
float flat_disc_distance(
    vec3 p,
    float radius,     // 0.7 [0, 100] [0.05, 5] m  Distance from the axis to where the edge begins.
    float thickness)  // 0.1 [0.001, 50] [0.01, 0.5] m  Thickness of the plate.
{
    float beyond = max(length(vec2(p.x, p.z)) - radius, 0.0f);
    return length(vec2(beyond, p.y)) - 0.5f * thickness;
}

Box flat_disc_bounds(float radius, float thickness)
{
    float edge = 0.5f * thickness;
    return make_box(vec3(0.0f), vec3(radius + edge, edge, radius + edge));
}
