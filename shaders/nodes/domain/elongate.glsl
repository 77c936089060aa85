// Elongate: Cuts a solid in the middle and stretches the cut, leaving the ends as they are.
// Exact for solids that are convex and symmetric.
// field: bound
// synonyms: stretch, lengthen, extend, pull apart
vec3 elongate_point(
    vec3 p,
    vec3 extension)  // (0.5, 0, 0) [0, 100] [0, 5] m  Half the length added along x, y and z.
{
    return p - clamp(p, -extension, extension);
}

Box elongate_bounds(vec3 extension, Box child)
{
    return make_box(child.centre, child.half_size + extension);
}
