// Capsule: A round rod along the y axis with half balls at its ends.
// field: exact
// synonyms: pill, rod, stadium
float capsule_distance(
    vec3 p,
    float radius,  // 0.3 [0.001, 100] [0.01, 2] m  Radius of the rod and of its ends.
    float height)  // 1.0 [0, 200] [0, 5] m  Length of the straight part.
{
    float along = max(abs(p.y) - 0.5f * height, 0.0f);
    return length(vec3(p.x, along, p.z)) - radius;
}

Box capsule_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height + radius, radius));
}
