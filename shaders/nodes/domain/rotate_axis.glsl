// Rotate about axis: Turns a solid around any axis through the origin.
// field: exact
// point: affine
// synonyms: axis-angle, turn, orient, spin, revolve
vec3 rotate_axis_unit(vec3 axis)
{
    float size = length(axis);
    return size > 1.0e-6f ? axis / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
}

vec3 rotate_axis_turned(vec3 v, vec3 unit, float angle)
{
    return v * cos(angle) + cross(unit, v) * sin(angle) + unit * (dot(unit, v) * (1.0f - cos(angle)));
}

vec3 rotate_axis_point(
    vec3 p,
    vec3 axis,    // (1, 0, 1) [-1000, 1000] [-1, 1]  Direction of the axis; its length does not matter.
    float angle)  // 45.0 [-3600, 3600] [-180, 180] deg  Turn around the axis.
{
    return rotate_axis_turned(p, rotate_axis_unit(axis), -angle);
}

Box rotate_axis_bounds(vec3 axis, float angle, Box child)
{
    vec3 unit = rotate_axis_unit(axis);
    vec3 along_x = abs(rotate_axis_turned(vec3(1.0f, 0.0f, 0.0f), unit, angle)) * child.half_size.x;
    vec3 along_y = abs(rotate_axis_turned(vec3(0.0f, 1.0f, 0.0f), unit, angle)) * child.half_size.y;
    vec3 along_z = abs(rotate_axis_turned(vec3(0.0f, 0.0f, 1.0f), unit, angle)) * child.half_size.z;
    // A millionth more, so that rounding neither clips the surface nor bounds what is unbounded.
    return make_box(rotate_axis_turned(child.centre, unit, angle), (along_x + along_y + along_z) * 1.000001f);
}
