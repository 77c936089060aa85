// Symmetry of a cube: Shows one of the 48 equal wedges of a cube in all of them.
// The wedge is where x is largest and z smallest. Exact for solids that lie inside the wedge.
// field: bound
// synonyms: octahedral, mirror, fold, kaleidoscope, cubic
vec3 symmetry_cube_point(
    vec3 p,
    vec3 offset)  // (1, 0, 0) [-1000, 1000] [-5, 5] m  How far the solid is moved along x, y and z first.
{
    vec3 q = abs(p);
    float largest = max(q.x, max(q.y, q.z));
    float smallest = min(q.x, min(q.y, q.z));
    float middle = max(min(q.x, q.y), min(max(q.x, q.y), q.z));
    return vec3(largest, middle, smallest) - offset;
}

Box symmetry_cube_bounds(vec3 offset, Box child)
{
    return make_box(vec3(0.0f), vec3(max(child.centre.x + child.half_size.x + offset.x, 0.0f)));
}
