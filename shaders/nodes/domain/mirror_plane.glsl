// Mirror plane: Shows what lies in front of a plane through the origin on both sides of it.
// What crosses the plane is cut there. Exact for solids that lie in front of it.
// field: bound
// synonyms: reflect, symmetry, flip, any direction, fold
vec3 mirror_plane_unit(vec3 normal)
{
    float size = length(normal);
    return size > 1.0e-6f ? normal / max(size, 1.0e-6f) : vec3(1.0f, 0.0f, 0.0f);
}

vec3 mirror_plane_point(
    vec3 p,
    vec3 normal,   // (1, 0, 1) [-1000, 1000] [-1, 1]  Direction that the mirror faces; its length does not matter.
    float offset)  // 0.7 [-1000, 1000] [-5, 5] m  How far the solid is moved in front of the mirror first.
{
    vec3 unit = mirror_plane_unit(normal);
    return p - unit * (2.0f * min(dot(p, unit), 0.0f) + offset);
}

Box mirror_plane_bounds(vec3 normal, float offset, Box child)
{
    vec3 unit = mirror_plane_unit(normal);
    vec3 centre = child.centre + unit * offset;
    vec3 along_x = abs(vec3(1.0f, 0.0f, 0.0f) - unit * (2.0f * unit.x)) * child.half_size.x;
    vec3 along_y = abs(vec3(0.0f, 1.0f, 0.0f) - unit * (2.0f * unit.y)) * child.half_size.y;
    vec3 along_z = abs(vec3(0.0f, 0.0f, 1.0f) - unit * (2.0f * unit.z)) * child.half_size.z;
    vec3 mirrored = centre - unit * (2.0f * dot(centre, unit));
    // A millionth more, so that rounding neither clips the surface nor bounds what is unbounded.
    return join_boxes(make_box(centre, child.half_size),
                      make_box(mirrored, (along_x + along_y + along_z) * 1.000001f));
}
