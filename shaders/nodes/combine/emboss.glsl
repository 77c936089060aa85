// Emboss: Raises the surface of the first shape where the second one covers it; the top keeps the first one's form.
// field: bound
// synonyms: raise, relief, stamp, boss, plateau
float emboss_distance(
    float a,
    float b,
    float height)  // 0.15 [0, 10] [0, 1] m  How far the surface rises.
{
    return min(a, max(a - height, b));
}

float emboss_blend(
    float a,
    float b,
    float height,
    int raised_face)  // b {a, b}  Whose material the new faces show.
{
    return raised_face == 1 && max(a - height, b) < a ? 1.0f : 0.0f;
}

Box emboss_bounds(Box box_a, float height)
{
    return grow_box(box_a, height);
}
