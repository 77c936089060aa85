// Cylinder: A round column along the y axis with flat ends.
// field: exact
// synonyms: column, disc, tube, can
float cylinder_distance(
    vec3 p,
    float radius,  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the axis to the side.
    float height)  // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float side = length(vec2(p.x, p.z)) - radius;
    float cap = abs(p.y) - 0.5f * height;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box cylinder_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height, radius));
}
