// Translate: Moves a solid.
// field: exact
// point: affine
// synonyms: move, position, shift, offset, place
vec3 translate_point(
    vec3 p,
    vec3 offset)  // (1, 0, 0) [-1000, 1000] [-5, 5] m  How far to move along x, y and z.
{
    return p - offset;
}

Box translate_bounds(vec3 offset, Box child)
{
    return make_box(child.centre + offset, child.half_size);
}
