// Intersect: Only what both shapes share.
// field: bound; exact
// synonyms: intersection, overlap, common, and
// combiner: hard associative
float intersect_distance(float a, float b)
{
    return max(a, b);
}

float intersect_blend(float a, float b)
{
    return b > a ? 1.0f : 0.0f;
}

bool intersect_shows_b(float a, float b)
{
    return b > a;
}

Box intersect_bounds(Box box_a, Box box_b)
{
    return overlap_boxes(box_a, box_b);
}
