// Repeat 2D: A block of copies of a flat shape, centred on the origin.
// Exact for shapes that stay in their cell, and for symmetric ones that leave it by up to half a cell.
// field: exact; bound
// synonyms: grid, pattern, clone, lattice, tile, array
// copies: 4
// combiner: hard

// Along one axis: the cell that holds x, or (further is 1) the one on the nearer side of it.
float repeat_2d_index(float x, float pitch, float number, float further)
{
    float last = max(floor(number + 0.5f), 1.0f) - 1.0f;
    float index = clamp(floor(x / pitch + 0.5f * last + 0.5f), 0.0f, last);
    float side = x < (index - 0.5f * last) * pitch ? -1.0f : 1.0f;
    // At the ends there is no further copy on that side; the one before takes its turn.
    float next = index + side;
    next = next < 0.0f || next > last ? index - side : next;
    return further > 0.5f ? clamp(next, 0.0f, last) : index;
}

vec3 repeat_2d_cell(
    vec2 p,
    vec2 spacing,  // (1.5, 1.5) [0.001, 1000] [0.1, 5] m  Distance between copies along x and y.
    vec2 count,    // (2, 2) [1, 1000] [1, 20]  Number of copies along x and y.
    int copy)
{
    float index_x = repeat_2d_index(p.x, spacing.x, count.x, float(copy % 2));
    float index_y = repeat_2d_index(p.y, spacing.y, count.y, float(copy / 2));
    return vec3(index_x, index_y, 0.0f);
}

vec2 repeat_2d_point(vec2 p, vec2 spacing, vec2 count, int copy)
{
    vec2 last = max(floor(count + vec2(0.5f)), vec2(1.0f)) - vec2(1.0f);
    vec3 cell = repeat_2d_cell(p, spacing, count, copy);
    return p - (vec2(cell.x, cell.y) - 0.5f * last) * spacing;
}

float repeat_2d_distance(float acc, float d)
{
    return min(acc, d);
}

Box repeat_2d_bounds(vec2 spacing, vec2 count, Box child)
{
    vec2 reach = 0.5f * (max(floor(count + vec2(0.5f)), vec2(1.0f)) - vec2(1.0f)) * spacing;
    return make_box(child.centre, child.half_size + vec3(reach.x, reach.y, 0.0f));
}
