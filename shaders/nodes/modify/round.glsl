// Round: Moves the surface outwards, which rounds edges and corners.
// field: exact; bound
// synonyms: offset, inflate, thicken, dilate, fillet, rounding
float round_distance(
    float d,
    float radius)  // 0.1 [0, 10] [0, 1] m  How far the surface moves; edges get this radius.
{
    return d - radius;
}

Box round_bounds(float radius, Box child)
{
    return grow_box(child, radius);
}
