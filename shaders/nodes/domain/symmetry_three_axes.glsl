// Symmetry on three axes: Shows one eighth of space in all eight.
// What crosses a mirror is cut there. Exact for solids that lie inside the eighth.
// field: bound
// synonyms: mirror, reflect, eight-fold, corners, octant
vec3 symmetry_three_axes_point(
    vec3 p,
    vec3 offset)  // (0.7, 0.7, 0.7) [-1000, 1000] [-5, 5] m  How far the solid is moved along x, y and z first.
{
    return abs(p) - offset;
}

Box symmetry_three_axes_bounds(vec3 offset, Box child)
{
    return make_box(vec3(0.0f), max(child.centre + offset + child.half_size, vec3(0.0f)));
}
