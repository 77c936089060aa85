// Symmetry on two axes: Shows one quarter of space in all four.
// What crosses a mirror is cut there. Exact for solids that lie inside the quarter.
// field: bound
// synonyms: mirror, reflect, four-fold, quad, table legs
vec3 symmetry_two_axes_moved(
    int axes,     // xz {xz, xy, yz}  The two axes that are mirrored.
    vec2 offset)  // (0.7, 0.7) [-1000, 1000] [-5, 5] m  How far the solid is moved along the two axes first.
{
    vec3 in_yz = vec3(0.0f, offset.x, offset.y);
    return axes == 0 ? vec3(offset.x, 0.0f, offset.y) : (axes == 1 ? vec3(offset.x, offset.y, 0.0f) : in_yz);
}

vec3 symmetry_two_axes_point(vec3 p, int axes, vec2 offset)
{
    vec3 q = vec3(axes == 2 ? p.x : abs(p.x), axes == 0 ? p.y : abs(p.y), axes == 1 ? p.z : abs(p.z));
    return q - symmetry_two_axes_moved(axes, offset);
}

Box symmetry_two_axes_bounds(int axes, vec2 offset, Box child)
{
    vec3 reach = max(child.centre + symmetry_two_axes_moved(axes, offset) + child.half_size, vec3(0.0f));
    bool x_stays = axes == 2;
    bool y_stays = axes == 0;
    bool z_stays = axes == 1;
    vec3 centre = vec3(x_stays ? child.centre.x : 0.0f, y_stays ? child.centre.y : 0.0f,
                       z_stays ? child.centre.z : 0.0f);
    vec3 half_size = vec3(x_stays ? child.half_size.x : reach.x, y_stays ? child.half_size.y : reach.y,
                          z_stays ? child.half_size.z : reach.z);
    return make_box(centre, half_size);
}
