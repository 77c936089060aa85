// Rotate 2D: Turns a flat shape counter-clockwise around the origin.
// field: exact
// synonyms: turn, orient, spin
vec2 rotate_2d_point(
    vec2 p,
    float angle)  // 30.0 [-3600, 3600] [-180, 180] deg  Turn, counter-clockwise.
{
    return vec2(p.x * cos(angle) + p.y * sin(angle), p.y * cos(angle) - p.x * sin(angle));
}

Box rotate_2d_bounds(float angle, Box child)
{
    float cosine = cos(angle);
    float sine = sin(angle);
    vec3 centre = vec3(child.centre.x * cosine - child.centre.y * sine, child.centre.x * sine + child.centre.y * cosine,
                       child.centre.z);
    float reach_x = child.half_size.x * abs(cosine) + child.half_size.y * abs(sine);
    float reach_y = child.half_size.x * abs(sine) + child.half_size.y * abs(cosine);
    // A millionth more, so that rounding neither clips the outline nor bounds what is unbounded.
    return make_box(centre, vec3(reach_x * 1.000001f, reach_y * 1.000001f, child.half_size.z));
}
