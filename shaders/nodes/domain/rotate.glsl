// Rotate: Turns a solid around x, then around y, then around z.
// field: exact
// point: affine
// synonyms: turn, orient, spin, euler
vec3 rotate_about_x(vec3 v, float angle)
{
    return vec3(v.x, v.y * cos(angle) - v.z * sin(angle), v.y * sin(angle) + v.z * cos(angle));
}

vec3 rotate_about_y(vec3 v, float angle)
{
    return vec3(v.x * cos(angle) + v.z * sin(angle), v.y, v.z * cos(angle) - v.x * sin(angle));
}

vec3 rotate_about_z(vec3 v, float angle)
{
    return vec3(v.x * cos(angle) - v.y * sin(angle), v.x * sin(angle) + v.y * cos(angle), v.z);
}

vec3 rotate_forward(vec3 v, vec3 angles)
{
    return rotate_about_z(rotate_about_y(rotate_about_x(v, angles.x), angles.y), angles.z);
}

vec3 rotate_point(
    vec3 p,
    vec3 angles)  // (0, 30, 0) [-3600, 3600] [-180, 180] deg  Turn around x, y and z.
{
    return rotate_about_x(rotate_about_y(rotate_about_z(p, -angles.z), -angles.y), -angles.x);
}

Box rotate_bounds(vec3 angles, Box child)
{
    vec3 along_x = abs(rotate_forward(vec3(1.0f, 0.0f, 0.0f), angles)) * child.half_size.x;
    vec3 along_y = abs(rotate_forward(vec3(0.0f, 1.0f, 0.0f), angles)) * child.half_size.y;
    vec3 along_z = abs(rotate_forward(vec3(0.0f, 0.0f, 1.0f), angles)) * child.half_size.z;
    // A millionth more, so that rounding neither clips the surface nor bounds what is unbounded.
    return make_box(rotate_forward(child.centre, angles), (along_x + along_y + along_z) * 1.000001f);
}
