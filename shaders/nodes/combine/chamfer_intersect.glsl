// Chamfer intersect: Only what both shapes share, its rim cut off with a flat bevel.
// field: bound
// synonyms: chamfered edge, rim, edge bevel
float chamfer_intersect_distance(
    float a,
    float b,
    float size)  // 0.25 [0, 10] [0, 1] m  How far from the rim the bevel starts on each surface.
{
    return max(max(a, b), (a + b + size) * 0.70710678f);
}

// Where both surfaces face the same way, both distances change at once.
float chamfer_intersect_lipschitz()
{
    return 1.41421357f;
}

float chamfer_intersect_blend(float a, float b)
{
    return b > a ? 1.0f : 0.0f;
}

bool chamfer_intersect_shows_b(float a, float b)
{
    return b > a;
}

Box chamfer_intersect_bounds(Box box_a, Box box_b)
{
    return overlap_boxes(box_a, box_b);
}
