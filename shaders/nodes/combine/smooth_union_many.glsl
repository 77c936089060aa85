// Smooth union of many: Up to sixteen shapes together, melted into each other where they meet.
// The shapes melt in pairs, and then the pairs: the order of the inputs shows a little where three meet.
// field: bound
// synonyms: blend, melt, soft union, metaballs, n-ary, list
// inputs: up to 16
float smooth_union_many_distance(
    float a,
    float b,
    float smoothness)  // 0.3 [0, 10] [0, 1] m  Size of the blend: it acts where two distances differ by less.
{
    float size = max(smoothness, 1.0e-6f);
    float overlap = max(size - abs(a - b), 0.0f);
    return min(a, b) - overlap * overlap * (0.25f / size);
}

float smooth_union_many_blend(float a, float b, float smoothness)
{
    float size = max(smoothness, 1.0e-6f);
    float share = 0.5f * max(size - abs(a - b), 0.0f) / size;
    return b < a ? 1.0f - share : share;
}

bool smooth_union_many_shows_b(float a, float b)
{
    return b <= a;
}

Box smooth_union_many_bounds(Box box_a, Box box_b, float smoothness)
{
    return grow_box(join_boxes(box_a, box_b), 0.25f * smoothness);
}
