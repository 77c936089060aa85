// Nested shells: Turns a solid into nested shells, one inside the other, which show where it is cut open.
// field: bound
// synonyms: layers, rings, concentric, onion
float nested_shells_distance(
    float d,
    int layers,       // 3 [1, 100] [1, 12]  Number of shells.
    float spacing,    // 0.12 [0.001, 100] [0.01, 1] m  Distance from shell to shell, inwards from the surface.
    float thickness)  // 0.04 [0.0001, 10] [0.005, 0.5] m  Thickness of each shell.
{
    float index = clamp(floor(0.5f - d / spacing), 0.0f, float(layers - 1));
    return abs(d + index * spacing) - 0.5f * thickness;
}

Box nested_shells_bounds(float thickness, Box child)
{
    return grow_box(child, 0.5f * thickness);
}
