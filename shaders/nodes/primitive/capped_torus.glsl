// Capped torus: A part of a ring around the y axis with round ends, open towards z.
// field: exact; bound
// synonyms: arc, open ring, broken ring, c shape
float capped_torus_distance(
    vec3 p,
    float major,  // 0.7 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of the tube.
    float minor,  // 0.2 [0.001, 100] [0.01, 2] m  Radius of the tube.
    float angle)  // 270.0 [0, 360] deg  How far the tube goes round.
{
    vec2 side = vec2(sin(0.5f * angle), cos(0.5f * angle));
    vec2 q = vec2(abs(p.x), -p.z);
    float across = side.y * q.x > side.x * q.y ? length(q - major * side) : abs(length(q) - major);
    return length(vec2(across, p.y)) - minor;
}

Box capped_torus_bounds(float major, float minor)
{
    return make_box(vec3(0.0f), vec3(major + minor, minor, major + minor));
}
