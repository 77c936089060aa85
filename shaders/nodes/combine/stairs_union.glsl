// Stairs union: Both shapes together, with a flight of steps where they meet.
// field: bound
// synonyms: stepped union, terrace, steps
float stairs_union_distance(
    float a,
    float b,
    float size,  // 0.4 [0.001, 10] [0.05, 1] m  How far from the seam the steps start on each surface.
    int steps)   // 4 [1, 64] [1, 12]  Number of steps.
{
    float step_size = size / float(steps);
    float rise = b - size - a + step_size;
    float wave = abs(rise - 2.0f * step_size * floor(rise / (2.0f * step_size)) - step_size);
    return min(min(a, b), 0.5f * (a + b - size + wave));
}

float stairs_union_blend(float a, float b)
{
    return b < a ? 1.0f : 0.0f;
}

bool stairs_union_shows_b(float a, float b)
{
    return b < a;
}

Box stairs_union_bounds(Box box_a, Box box_b, float size)
{
    return grow_box(join_boxes(box_a, box_b), 0.5f * size);
}
