// Mirror: Shows what lies on the positive side of a plane on both sides of it.
// What crosses the plane is cut there. Exact for solids that lie on the positive side.
// field: bound
// synonyms: reflect, symmetry, flip, symmetric
vec3 mirror_point(
    vec3 p,
    int axis,      // x {x, y, z}  Axis that the mirror faces.
    float offset)  // 0.75 [-1000, 1000] [-5, 5] m  How far the solid is moved away from the mirror first.
{
    vec3 q = vec3(axis == 0 ? abs(p.x) : p.x, axis == 1 ? abs(p.y) : p.y, axis == 2 ? abs(p.z) : p.z);
    return q - vec3(axis == 0 ? offset : 0.0f, axis == 1 ? offset : 0.0f, axis == 2 ? offset : 0.0f);
}

Box mirror_bounds(int axis, float offset, Box child)
{
    vec3 reach = max(child.centre + child.half_size + vec3(offset), vec3(0.0f));
    vec3 centre = vec3(axis == 0 ? 0.0f : child.centre.x, axis == 1 ? 0.0f : child.centre.y,
                       axis == 2 ? 0.0f : child.centre.z);
    vec3 half_size = vec3(axis == 0 ? reach.x : child.half_size.x, axis == 1 ? reach.y : child.half_size.y,
                          axis == 2 ? reach.z : child.half_size.z);
    return make_box(centre, half_size);
}
