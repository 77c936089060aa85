// Inversion: Turns space inside out at a sphere: what was near the centre is far away, and planes become spheres.
// field: bound
// synonyms: invert space, sphere inversion, reciprocal, moebius, inside out
vec3 inversion_point(
    vec3 p,
    float radius,  // 1.0 [0.01, 1000] [0.1, 5] m  Radius of the sphere; what lies on it stays.
    vec3 offset)   // (1.3, 0, 0) [-1000, 1000] [-5, 5] m  How far the solid is moved from the centre first.
{
    return p * (radius * radius / max(dot(p, p), 1.0e-8f)) - offset;
}

// No surface enters the inverted image of the ball that the distance keeps free.
float inversion_distance(vec3 p, float d, float radius)
{
    float reach = max(length(p), 1.0e-4f);
    return d * reach * reach / (radius * radius + abs(d) * reach);
}

Box inversion_bounds(float radius, vec3 offset, Box child)
{
    vec3 gap = max(abs(child.centre + offset) - child.half_size, vec3(0.0f));
    float nearest = length(gap);
    float reach = radius * radius / max(nearest, 1.0e-9f) * 1.0001f;
    return make_box(vec3(0.0f), vec3(reach));
}
