// Superellipsoid: A shape between an octahedron, a ball and a block, with a radius of its own along each axis.
// field: bound
// synonyms: superquadric, squircle, squircular, soft block
float superellipsoid_distance(
    vec3 p,
    vec3 radii,      // (0.8, 0.6, 0.6) [0.001, 100] [0.05, 5] m  Radius along x, y and z.
    float exponent)  // 4.0 [1, 16]  How square it is: 1 is an octahedron, 2 a ball, 16 nearly a block.
{
    vec3 q = abs(p) / radii;
    float most = max(q.x, max(q.y, q.z));
    vec3 share = max(q / max(most, 1.0e-6f), vec3(1.0e-4f));
    float sum = pow(share.x, exponent) + pow(share.y, exponent) + pow(share.z, exponent);
    float size = most * pow(sum, 1.0f / exponent);
    // The norm of exponents below 2 is steeper than the length, at most by this.
    float steep = pow(3.0f, max(1.0f / exponent - 0.5f, 0.0f));
    float solid = (size - 1.0f) * min(radii.x, min(radii.y, radii.z)) / steep;
    vec3 beyond = abs(p) - radii;
    float around = length(max(beyond, vec3(0.0f))) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0f);
    return max(solid, around);
}

Box superellipsoid_bounds(vec3 radii)
{
    return make_box(vec3(0.0f), radii);
}
