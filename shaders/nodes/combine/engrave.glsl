// Engrave: Cuts a sharp groove into the first shape along the surface of the second.
// field: bound
// synonyms: v groove, scratch, score, line
float engrave_distance(
    float a,
    float b,
    float depth)  // 0.1 [0, 10] [0, 1] m  Depth of the groove; at the surface it is twice as wide.
{
    return max(a, (a + depth - abs(b)) * 0.70710678f);
}

// Where both surfaces face the same way, both distances change at once.
float engrave_lipschitz()
{
    return 1.41421357f;
}

float engrave_blend(
    float a,
    float b,
    float depth,
    int cut_face)  // b {a, b}  Whose material the new faces show.
{
    return cut_face == 1 && (a + depth - abs(b)) * 0.70710678f > a ? 1.0f : 0.0f;
}

Box engrave_bounds(Box box_a)
{
    return box_a;
}
