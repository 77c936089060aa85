// Exclusive or: What lies in one of the shapes but not in both.
// field: exact
// synonyms: xor, symmetric difference, either
// combiner: hard
float exclusive_or_distance(float a, float b)
{
    return max(min(a, b), -max(a, b));
}

float exclusive_or_blend(float a, float b)
{
    return abs(b) < abs(a) ? 1.0f : 0.0f;
}

bool exclusive_or_shows_b(float a, float b)
{
    return abs(b) < abs(a);
}

Box exclusive_or_bounds(Box box_a, Box box_b)
{
    return join_boxes(box_a, box_b);
}
