// Clip by plane: Cuts away what lies in front of a plane.
// field: bound
// synonyms: cut, slice off, half, section, trim, crop
// combiner: hard
float clip_plane_distance(
    vec3 p,
    float d,
    vec3 normal,   // (1, 1, 1) [-1000, 1000] [-1, 1]  Direction that the plane faces; its length does not matter.
    float offset)  // 0.2 [-1000, 1000] [-5, 5] m  Distance of the plane from the origin, in that direction.
{
    float size = length(normal);
    vec3 unit = size > 1.0e-6f ? normal / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    return max(d, dot(p, unit) - offset);
}

Box clip_plane_bounds(Box child)
{
    return child;
}
