// Sphere: A ball around the origin.
// field: exact
// synonyms: ball, globe, orb
float sphere_distance(
    vec3 p,
    float radius)  // 1.0 [0.001, 100] [0.05, 5] m  Distance from the centre to the surface.
{
    return length(p) - radius;
}

Box sphere_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius));
}
