// Columns union: Both shapes together, with a bundle of round columns along the seam.
// field: bound
// synonyms: bead union, reeds, fluted, pillars
float columns_union_distance(
    float a,
    float b,
    float size,   // 0.4 [0.001, 10] [0.05, 1] m  How far from the seam the columns start on each surface.
    int columns)  // 3 [1, 64] [1, 12]  Number of columns.
{
    float radius = size * 1.41421356f / (2.0f * float(columns) - 0.58578644f);
    // Across the bevel and along it; both surfaces are taken as meeting at a right angle.
    float across = 0.70710678f * (a + b - size) + radius * 1.41421356f;
    float along = 0.70710678f * (b - a);
    float first = radius * (1.0f - float(columns));
    float number = clamp(floor((along - first) / (2.0f * radius) + 0.5f), 0.0f, float(columns - 1));
    float column = length(vec2(across, along - first - 2.0f * radius * number)) - radius;
    return min(min(a, b), min(across, column));
}

// Where both surfaces face the same way, both distances change at once.
float columns_union_lipschitz()
{
    return 1.41421357f;
}

float columns_union_blend(float a, float b)
{
    return b < a ? 1.0f : 0.0f;
}

bool columns_union_shows_b(float a, float b)
{
    return b < a;
}

Box columns_union_bounds(Box box_a, Box box_b, float size)
{
    return grow_box(join_boxes(box_a, box_b), size);
}
