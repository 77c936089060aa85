// Union of many: All shapes together, up to sixteen in one node.
// field: exact; bound
// synonyms: add, join, merge, collect, list, n-ary, scene
// combiner: hard associative
// inputs: up to 16
float union_many_distance(float a, float b)
{
    return min(a, b);
}

float union_many_blend(float a, float b)
{
    return b < a ? 1.0f : 0.0f;
}

bool union_many_shows_b(float a, float b)
{
    return b < a;
}

Box union_many_bounds(Box box_a, Box box_b)
{
    return join_boxes(box_a, box_b);
}
