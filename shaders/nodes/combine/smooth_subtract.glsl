// Smooth subtract: The first shape without the second, with a rounded rim around the cut.
// field: bound
// synonyms: soft difference, smooth cut, smooth difference, carve
float smooth_subtract_distance(
    float a,
    float b,
    float smoothness)  // 0.2 [0, 10] [0, 1] m  Size of the blend: it acts where the two surfaces are nearer than this.
{
    float size = max(smoothness, 1.0e-6f);
    float overlap = max(size - abs(a + b), 0.0f);
    return max(a, -b) + overlap * overlap * (0.25f / size);
}

float smooth_subtract_blend(
    float a,
    float b,
    float smoothness,
    int cut_face)  // a {a, b, nearer}  Whose material the cut shows: a's, b's mixed in softly, or the nearer one's.
{
    float size = max(smoothness, 1.0e-6f);
    float share = 0.5f * max(size - abs(a + b), 0.0f) / size;
    float mixed = -b > a ? 1.0f - share : share;
    float nearer_b = -b > a ? 1.0f : 0.0f;
    return cut_face == 0 ? 0.0f : (cut_face == 1 ? mixed : nearer_b);
}

Box smooth_subtract_bounds(Box box_a)
{
    return box_a;
}
