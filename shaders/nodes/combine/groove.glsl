// Groove: Cuts a square channel into the first shape along the surface of the second.
// field: bound
// synonyms: channel, slot, rabbet, panel line
float groove_distance(
    float a,
    float b,
    float depth,  // 0.1 [0, 10] [0, 1] m  Depth of the channel.
    float width)  // 0.15 [0, 10] [0.01, 1] m  Width of the channel.
{
    return max(a, min(a + depth, 0.5f * width - abs(b)));
}

float groove_blend(
    float a,
    float b,
    float depth,
    float width,
    int cut_face)  // b {a, b}  Whose material the new faces show.
{
    return cut_face == 1 && min(a + depth, 0.5f * width - abs(b)) > a ? 1.0f : 0.0f;
}

Box groove_bounds(Box box_a)
{
    return box_a;
}
