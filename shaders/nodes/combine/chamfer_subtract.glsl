// Chamfer subtract: The first shape without the second, the rim of the cut bevelled.
// field: bound
// synonyms: countersink, chamfered cut, edge bevel
float chamfer_subtract_distance(
    float a,
    float b,
    float size)  // 0.2 [0, 10] [0, 1] m  How far from the rim the bevel starts on each surface.
{
    return max(max(a, -b), (a - b + size) * 0.70710678f);
}

// Where both surfaces face the same way, both distances change at once.
float chamfer_subtract_lipschitz()
{
    return 1.41421357f;
}

float chamfer_subtract_blend(
    float a,
    float b,
    int cut_face)  // a {a, b, nearer}  Whose material the cut shows: a's, b's, or that of the nearer surface.
{
    float beyond_cut = -b > a ? 1.0f : 0.0f;
    float nearer_b = abs(b) < abs(a) ? 1.0f : 0.0f;
    return cut_face == 0 ? 0.0f : (cut_face == 1 ? beyond_cut : nearer_b);
}

bool chamfer_subtract_shows_b(float a, float b, int cut_face)
{
    return cut_face == 1 ? -b > a : (cut_face == 2 && abs(b) < abs(a));
}

Box chamfer_subtract_bounds(Box box_a)
{
    return box_a;
}
