// Translate 2D: Moves a flat shape.
// field: exact
// synonyms: move, position, shift, offset, place
vec2 translate_2d_point(
    vec2 p,
    vec2 offset)  // (0.5, 0) [-1000, 1000] [-5, 5] m  How far to move along x and y.
{
    return p - offset;
}

Box translate_2d_bounds(vec2 offset, Box child)
{
    return make_box(child.centre + vec3(offset.x, offset.y, 0.0f), child.half_size);
}
