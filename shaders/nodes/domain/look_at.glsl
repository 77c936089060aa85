// Look at: Turns a solid so that its z axis points at a target and its y axis stays as upright as it can.
// field: exact
// point: affine
// synonyms: aim, point at, orient, track to, face
vec3 look_at_forward(vec3 target)
{
    float size = length(target);
    return size > 1.0e-6f ? target / max(size, 1.0e-6f) : vec3(0.0f, 0.0f, 1.0f);
}

vec3 look_at_right(vec3 forward)
{
    vec3 up = abs(forward.y) > 0.9999f ? vec3(0.0f, 0.0f, -1.0f) : vec3(0.0f, 1.0f, 0.0f);
    return normalize(cross(up, forward));
}

vec3 look_at_point(
    vec3 p,
    vec3 target)  // (1, 1, 2) [-1000, 1000] [-5, 5] m  Where the z axis points.
{
    vec3 forward = look_at_forward(target);
    vec3 right = look_at_right(forward);
    return vec3(dot(p, right), dot(p, cross(forward, right)), dot(p, forward));
}

Box look_at_bounds(vec3 target, Box child)
{
    vec3 forward = look_at_forward(target);
    vec3 right = look_at_right(forward);
    vec3 up = cross(forward, right);
    vec3 centre = right * child.centre.x + up * child.centre.y + forward * child.centre.z;
    vec3 half_size = abs(right) * child.half_size.x + abs(up) * child.half_size.y + abs(forward) * child.half_size.z;
    // A millionth more, so that rounding neither clips the surface nor bounds what is unbounded.
    return make_box(centre, half_size * 1.000001f);
}
