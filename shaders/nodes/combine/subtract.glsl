// Subtract: The first shape without the second.
// field: bound; exact
// synonyms: difference, cut, carve, minus, drill
// combiner: hard
float subtract_distance(float a, float b)
{
    return max(a, -b);
}

float subtract_blend(
    float a,
    float b,
    int cut_face)  // a {a, b, nearer}  Whose material the cut shows: a's, b's, or that of the nearer surface.
{
    float beyond_cut = -b > a ? 1.0f : 0.0f;
    float nearer_b = abs(b) < abs(a) ? 1.0f : 0.0f;
    return cut_face == 0 ? 0.0f : (cut_face == 1 ? beyond_cut : nearer_b);
}

bool subtract_shows_b(float a, float b, int cut_face)
{
    return cut_face == 1 ? -b > a : (cut_face == 2 && abs(b) < abs(a));
}

Box subtract_bounds(Box box_a)
{
    return box_a;
}
