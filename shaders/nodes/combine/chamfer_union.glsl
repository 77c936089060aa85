// Chamfer union: Both shapes together, with a flat bevel where they meet.
// field: bound
// synonyms: chamfered seam, weld, gusset, edge bevel
float chamfer_union_distance(
    float a,
    float b,
    float size)  // 0.3 [0, 10] [0, 1] m  How far from the seam the bevel starts on each surface.
{
    return min(min(a, b), (a + b - size) * 0.70710678f);
}

// Where both surfaces face the same way, both distances change at once.
float chamfer_union_lipschitz()
{
    return 1.41421357f;
}

float chamfer_union_blend(float a, float b)
{
    return b < a ? 1.0f : 0.0f;
}

bool chamfer_union_shows_b(float a, float b)
{
    return b < a;
}

Box chamfer_union_bounds(Box box_a, Box box_b, float size)
{
    return grow_box(join_boxes(box_a, box_b), 0.5f * size);
}
