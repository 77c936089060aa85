// Smooth exclusive or: What lies in one of the shapes but not in both, with rounded rims.
// field: bound
// synonyms: soft xor, soft symmetric difference
float smooth_exclusive_or_distance(
    float a,
    float b,
    float smoothness)  // 0.2 [0, 10] [0, 1] m  Size of the blend: it acts where the two distances differ by less.
{
    float size = max(smoothness, 1.0e-6f);
    float overlap = max(size - abs(a - b), 0.0f);
    float melt = overlap * overlap * (0.25f / size);
    float either = min(a, b) - melt;
    float not_both = -max(a, b) - melt;
    float rim = max(size - abs(either - not_both), 0.0f);
    return max(either, not_both) + rim * rim * (0.25f / size);
}

float smooth_exclusive_or_blend(float a, float b, float smoothness)
{
    float size = max(smoothness, 1.0e-6f);
    float share = 0.5f * max(size - abs(abs(a) - abs(b)), 0.0f) / size;
    return abs(b) < abs(a) ? 1.0f - share : share;
}

bool smooth_exclusive_or_shows_b(float a, float b)
{
    return abs(b) <= abs(a);
}

Box smooth_exclusive_or_bounds(Box box_a, Box box_b, float smoothness)
{
    return grow_box(join_boxes(box_a, box_b), 0.25f * smoothness);
}
