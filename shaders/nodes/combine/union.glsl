// Union: Both shapes together.
// field: exact; bound
// synonyms: add, join, merge, or, combine
// combiner: hard associative
float union_distance(float a, float b)
{
    return min(a, b);
}

float union_blend(float a, float b)
{
    return b < a ? 1.0f : 0.0f;
}

bool union_shows_b(float a, float b)
{
    return b < a;
}

Box union_bounds(Box box_a, Box box_b)
{
    return join_boxes(box_a, box_b);
}
