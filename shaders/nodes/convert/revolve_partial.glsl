// Partial revolve: Turns a flat shape part of the way around the y axis, like a slice of cake or a pipe bend.
// The part of the shape left of the axis is not seen.
// field: bound
// synonyms: lathe, cake slice, elbow, arc, spin, cut away, 2d to 3d
vec2 revolve_partial_point(
    vec3 p,
    float offset)  // 1.0 [0, 100] [0, 5] m  How far the shape is moved away from the axis.
{
    return vec2(length(vec2(p.x, p.z)) - offset, p.y);
}

float revolve_partial_distance(
    vec3 p,
    float d,
    float start,  // 0.0 [-360, 360] deg  Where the turn begins, from the x axis towards the viewer.
    float sweep)  // 240.0 [0, 360] deg  How far the turn goes.
{
    float middle = start + 0.5f * sweep;
    float along = p.x * cos(middle) + p.z * sin(middle);
    float across = p.z * cos(middle) - p.x * sin(middle);
    float outside = abs(across) * cos(0.5f * sweep) - along * sin(0.5f * sweep);
    return sweep > 6.2831f ? d : max(d, outside);
}

Box revolve_partial_bounds(float offset, Box child)
{
    float reach = max(child.centre.x + child.half_size.x + offset, 0.0f);
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(reach, child.half_size.y, reach));
}
