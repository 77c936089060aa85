// Link: A link of a chain, upright in the plane of x and y.
// field: exact; bound
// synonyms: chain link, stretched torus, oval ring
float link_distance(
    vec3 p,
    float major,   // 0.4 [0.001, 100] [0.05, 5] m  Distance from the middle of the tube to the centre of each bow.
    float minor,   // 0.12 [0.001, 100] [0.01, 2] m  Radius of the tube.
    float height)  // 0.6 [0, 100] [0, 5] m  Length of the straight parts.
{
    float along = max(abs(p.y) - 0.5f * height, 0.0f);
    float across = length(vec2(p.x, along)) - major;
    return length(vec2(across, p.z)) - minor;
}

Box link_bounds(float major, float minor, float height)
{
    float reach = major + minor;
    return make_box(vec3(0.0f), vec3(reach, reach + 0.5f * height, minor));
}
