// Rounded intersect: Only what both shapes share, its rim rounded with a true radius where they meet at right angles.
// field: bound
// synonyms: fillet intersection, round intersection, rounded edge
float rounded_intersect_distance(
    float a,
    float b,
    float radius)  // 0.25 [0, 10] [0, 1] m  Radius of the rim.
{
    vec2 within = max(vec2(radius + a, radius + b), vec2(0.0f));
    return min(-radius, max(a, b)) + length(within);
}

// Where both surfaces face the same way, both distances change at once.
float rounded_intersect_lipschitz()
{
    return 1.41421357f;
}

float rounded_intersect_blend(float a, float b, float radius)
{
    float size = max(radius, 1.0e-6f);
    float share = 0.5f * max(size - abs(a - b), 0.0f) / size;
    return b > a ? 1.0f - share : share;
}

bool rounded_intersect_shows_b(float a, float b)
{
    return b >= a;
}

Box rounded_intersect_bounds(Box box_a, Box box_b)
{
    return overlap_boxes(box_a, box_b);
}
