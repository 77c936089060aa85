// Inset: Sinks the surface of the first shape where the second one covers it; the floor keeps the first one's form.
// field: bound
// synonyms: pocket, recess, deboss, inlay, sink
float inset_distance(
    float a,
    float b,
    float depth)  // 0.15 [0, 10] [0, 1] m  How far the surface sinks.
{
    return max(a, min(a + depth, -b));
}

float inset_blend(
    float a,
    float b,
    float depth,
    int cut_face)  // b {a, b}  Whose material the new faces show.
{
    return cut_face == 1 && min(a + depth, -b) > a ? 1.0f : 0.0f;
}

Box inset_bounds(Box box_a)
{
    return box_a;
}
