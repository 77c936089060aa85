// Grid: Crossing lines between rows and columns of square cells.
// field: exact; bound
// synonyms: lattice, mesh, lines, fence, window
// Distance to the nearest of several parallel lines, each a rectangle.
float grid_lines(float across, float along, float count, float spacing, float reach, float half_line)
{
    float number = clamp(floor(across / spacing + 0.5f * count + 0.5f), 0.0f, count);
    vec2 q = vec2(abs(across - (number - 0.5f * count) * spacing), abs(along)) - vec2(half_line, reach + half_line);
    return length(max(q, vec2(0.0f))) + min(max(q.x, q.y), 0.0f);
}

float grid_distance(
    vec2 p,
    int columns,      // 4 [1, 1000] [1, 20]  Cells from left to right.
    int rows,         // 3 [1, 1000] [1, 20]  Cells from bottom to top.
    float spacing,    // 0.3 [0.001, 100] [0.05, 2] m  Size of a cell, from the middle of a line to the next.
    float thickness)  // 0.06 [0.001, 100] [0.01, 1] m  Width of the lines.
{
    vec2 reach = 0.5f * spacing * vec2(float(columns), float(rows));
    float upright = grid_lines(p.x, p.y, float(columns), spacing, reach.y, 0.5f * thickness);
    float level = grid_lines(p.y, p.x, float(rows), spacing, reach.x, 0.5f * thickness);
    return min(upright, level);
}

Box grid_bounds(int columns, int rows, float spacing, float thickness)
{
    vec2 reach = 0.5f * (spacing * vec2(float(columns), float(rows)) + vec2(thickness));
    return make_box(vec3(0.0f), vec3(reach.x, reach.y, 0.0f));
}
