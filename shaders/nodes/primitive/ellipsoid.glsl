// Ellipsoid: A ball with a radius of its own along each axis.
// field: bound
// synonyms: egg, oval, stretched sphere
float ellipsoid_distance(
    vec3 p,
    vec3 radii)  // (1.0, 0.6, 0.8) [0.001, 100] [0.05, 5] m  Radius along x, y and z.
{
    // Both the scaled ball and the box around it never overshoot; the larger of the two does not either.
    float ball = (length(p / radii) - 1.0f) * min(radii.x, min(radii.y, radii.z));
    vec3 q = abs(p) - radii;
    float around = length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f);
    return max(ball, around);
}

Box ellipsoid_bounds(vec3 radii)
{
    return make_box(vec3(0.0f), radii);
}
