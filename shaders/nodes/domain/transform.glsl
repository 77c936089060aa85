// Transform: Scales a solid, then turns it around x, y and z, then moves it.
// field: exact
// point: affine
// synonyms: move rotate scale, placement, pose, trs, matrix
// combiner: hard
vec3 transform_about_x(vec3 v, float angle)
{
    return vec3(v.x, v.y * cos(angle) - v.z * sin(angle), v.y * sin(angle) + v.z * cos(angle));
}

vec3 transform_about_y(vec3 v, float angle)
{
    return vec3(v.x * cos(angle) + v.z * sin(angle), v.y, v.z * cos(angle) - v.x * sin(angle));
}

vec3 transform_about_z(vec3 v, float angle)
{
    return vec3(v.x * cos(angle) - v.y * sin(angle), v.x * sin(angle) + v.y * cos(angle), v.z);
}

vec3 transform_turned(vec3 v, vec3 angles)
{
    return transform_about_z(transform_about_y(transform_about_x(v, angles.x), angles.y), angles.z);
}

vec3 transform_point(
    vec3 p,
    vec3 offset,   // (0.5, 0, 0) [-1000, 1000] [-5, 5] m  How far to move along x, y and z.
    vec3 angles,   // (0, 30, 0) [-3600, 3600] [-180, 180] deg  Turn around x, y and z.
    float factor)  // 1.2 [0.001, 1000] [0.1, 5]  How many times as large.
{
    vec3 q = p - offset;
    return transform_about_x(transform_about_y(transform_about_z(q, -angles.z), -angles.y), -angles.x) / factor;
}

float transform_distance(float d, float factor)
{
    return d * factor;
}

Box transform_bounds(vec3 offset, vec3 angles, float factor, Box child)
{
    vec3 along_x = abs(transform_turned(vec3(1.0f, 0.0f, 0.0f), angles)) * child.half_size.x;
    vec3 along_y = abs(transform_turned(vec3(0.0f, 1.0f, 0.0f), angles)) * child.half_size.y;
    vec3 along_z = abs(transform_turned(vec3(0.0f, 0.0f, 1.0f), angles)) * child.half_size.z;
    // A millionth more, so that rounding does not clip the surface; what is unbounded stays so.
    vec3 half_size = (along_x + along_y + along_z) * 1.000001f;
    float largest = max(half_size.x, max(half_size.y, half_size.z));
    half_size = largest >= UNBOUNDED ? vec3(UNBOUNDED) : half_size * factor;
    return make_box(transform_turned(child.centre, angles) * factor + offset, half_size);
}
