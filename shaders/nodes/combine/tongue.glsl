// Tongue: Adds a square ridge to the first shape along the surface of the second.
// field: bound
// synonyms: ridge, rib, fin, rail, spline joint
float tongue_distance(
    float a,
    float b,
    float height,  // 0.1 [0, 10] [0, 1] m  Height of the ridge.
    float width)   // 0.15 [0, 10] [0.01, 1] m  Width of the ridge.
{
    return min(a, max(a - height, abs(b) - 0.5f * width));
}

float tongue_blend(
    float a,
    float b,
    float height,
    float width,
    int ridge_face)  // b {a, b}  Whose material the new faces show.
{
    return ridge_face == 1 && max(a - height, abs(b) - 0.5f * width) < a ? 1.0f : 0.0f;
}

Box tongue_bounds(Box box_a, float height)
{
    return grow_box(box_a, height);
}
