// Torus: A ring around the y axis.
// field: exact; bound
// synonyms: ring, donut, doughnut, tyre
float torus_distance(
    vec3 p,
    float major,  // 1.0 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of the tube.
    float minor)  // 0.25 [0.001, 100] [0.01, 2] m  Radius of the tube.
{
    float across = length(vec2(p.x, p.z)) - major;
    return length(vec2(across, p.y)) - minor;
}

Box torus_bounds(float major, float minor)
{
    return make_box(vec3(0.0f), vec3(major + minor, minor, major + minor));
}
