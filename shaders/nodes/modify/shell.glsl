// Shell: Hollows a shape out and keeps a wall around its surface.
// field: exact; bound
// synonyms: onion, hollow, wall, skin, outline
float shell_distance(
    float d,
    float thickness)  // 0.1 [0.001, 10] [0.01, 1] m  Thickness of the wall, half of it to each side of the surface.
{
    return abs(d) - 0.5f * thickness;
}

Box shell_bounds(float thickness, Box child)
{
    return grow_box(child, 0.5f * thickness);
}
