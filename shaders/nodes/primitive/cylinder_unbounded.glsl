// Endless cylinder: A round column along the y axis without ends.
// field: exact
// synonyms: infinite cylinder, unbounded cylinder, pole
float cylinder_unbounded_distance(
    vec3 p,
    float radius)  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the axis to the side.
{
    return length(vec2(p.x, p.z)) - radius;
}

Box cylinder_unbounded_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius, UNBOUNDED, radius));
}
