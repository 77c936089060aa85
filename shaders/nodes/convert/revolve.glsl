// Revolve: Turns a flat shape around the y axis, like a piece on a lathe.
// The part of the shape left of the axis is not seen. Exact for shapes that lie right of the axis.
// field: bound
// synonyms: lathe, spin, turn, solid of revolution, 2d to 3d
vec2 revolve_point(
    vec3 p,
    float offset)  // 1.0 [0, 100] [0, 5] m  How far the shape is moved away from the axis.
{
    return vec2(length(vec2(p.x, p.z)) - offset, p.y);
}

Box revolve_bounds(float offset, Box child)
{
    float reach = max(child.centre.x + child.half_size.x + offset, 0.0f);
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(reach, child.half_size.y, reach));
}
