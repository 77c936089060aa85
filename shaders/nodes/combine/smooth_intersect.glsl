// Smooth intersect: Only what both shapes share, with a rounded rim where they meet.
// field: bound
// synonyms: soft intersection, smooth overlap, smax
float smooth_intersect_distance(
    float a,
    float b,
    float smoothness)  // 0.2 [0, 10] [0, 1] m  Size of the blend: it acts where the two distances differ by less.
{
    float size = max(smoothness, 1.0e-6f);
    float overlap = max(size - abs(a - b), 0.0f);
    return max(a, b) + overlap * overlap * (0.25f / size);
}

float smooth_intersect_blend(float a, float b, float smoothness)
{
    float size = max(smoothness, 1.0e-6f);
    float share = 0.5f * max(size - abs(a - b), 0.0f) / size;
    return b > a ? 1.0f - share : share;
}

bool smooth_intersect_shows_b(float a, float b)
{
    return b >= a;
}

Box smooth_intersect_bounds(Box box_a, Box box_b)
{
    return overlap_boxes(box_a, box_b);
}
