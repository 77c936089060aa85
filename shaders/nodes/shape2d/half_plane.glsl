// Half-plane: Everything on one side of an endless straight line.
// field: exact
// synonyms: half space 2d, line, side, floor, cut
float half_plane_distance(
    vec2 p,
    float angle,   // 90.0 [-3600, 3600] [-180, 180] deg  Direction that it faces, counter-clockwise from the right.
    float offset)  // 0.0 [-1000, 1000] [-5, 5] m  Distance from the origin to the line in that direction.
{
    return p.x * cos(angle) + p.y * sin(angle) - offset;
}

Box half_plane_bounds()
{
    return everywhere();
}
