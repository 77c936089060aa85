// Rounded subtract: The first shape without the second, the rim of the cut rounded with a true radius.
// field: bound
// synonyms: fillet difference, round difference, rounded cut, carve
float rounded_subtract_distance(
    float a,
    float b,
    float radius)  // 0.2 [0, 10] [0, 1] m  Radius of the rim.
{
    vec2 within = max(vec2(radius + a, radius - b), vec2(0.0f));
    return min(-radius, max(a, -b)) + length(within);
}

// Where both surfaces face the same way, both distances change at once.
float rounded_subtract_lipschitz()
{
    return 1.41421357f;
}

float rounded_subtract_blend(
    float a,
    float b,
    float radius,
    int cut_face)  // a {a, b, nearer}  Whose material the cut shows: a's, b's mixed in softly, or the nearer one's.
{
    float size = max(radius, 1.0e-6f);
    float share = 0.5f * max(size - abs(a + b), 0.0f) / size;
    float mixed = -b > a ? 1.0f - share : share;
    float nearer_b = -b > a ? 1.0f : 0.0f;
    return cut_face == 0 ? 0.0f : (cut_face == 1 ? mixed : nearer_b);
}

Box rounded_subtract_bounds(Box box_a)
{
    return box_a;
}
