// Repeat limited: A block of copies of a solid, centred on the origin.
// Exact for solids that stay in their cell, and for symmetric ones that leave it by up to half a cell.
// field: exact; bound
// synonyms: array, grid, row, clone, tile, lattice
// copies: 8
// combiner: hard

// Along one axis: the cell that holds x, or (further is 1) the one on the nearer side of it.
float repeat_limited_index(float x, float pitch, float number, float further)
{
    float last = max(floor(number + 0.5f), 1.0f) - 1.0f;
    float index = clamp(floor(x / pitch + 0.5f * last + 0.5f), 0.0f, last);
    float side = x < (index - 0.5f * last) * pitch ? -1.0f : 1.0f;
    // At the ends there is no further copy on that side; the one before takes its turn.
    float next = index + side;
    next = next < 0.0f || next > last ? index - side : next;
    return further > 0.5f ? clamp(next, 0.0f, last) : index;
}

vec3 repeat_limited_cell(
    vec3 p,
    vec3 spacing,  // (1.5, 1.5, 1.5) [0.001, 1000] [0.1, 5] m  Distance between copies along x, y and z.
    vec3 count,    // (3, 1, 3) [1, 1000] [1, 20]  Number of copies along x, y and z.
    int copy)
{
    float index_x = repeat_limited_index(p.x, spacing.x, count.x, float(copy % 2));
    int copy_yz = count.x < 1.5f ? copy : copy / 2;
    float index_y = repeat_limited_index(p.y, spacing.y, count.y, float(copy_yz % 2));
    int copy_z = count.y < 1.5f ? copy_yz : copy_yz / 2;
    float index_z = repeat_limited_index(p.z, spacing.z, count.z, float(copy_z % 2));
    return vec3(index_x, index_y, index_z);
}

vec3 repeat_limited_point(vec3 p, vec3 spacing, vec3 count, int copy)
{
    vec3 last = max(floor(count + vec3(0.5f)), vec3(1.0f)) - vec3(1.0f);
    return p - (repeat_limited_cell(p, spacing, count, copy) - 0.5f * last) * spacing;
}

// Two along each axis with more than one.
int repeat_limited_copies(vec3 count)
{
    return (count.x < 1.5f ? 1 : 2) * (count.y < 1.5f ? 1 : 2) * (count.z < 1.5f ? 1 : 2);
}

float repeat_limited_distance(float acc, float d)
{
    return min(acc, d);
}

Box repeat_limited_bounds(vec3 spacing, vec3 count, Box child)
{
    vec3 last = max(floor(count + vec3(0.5f)), vec3(1.0f)) - vec3(1.0f);
    return make_box(child.centre, child.half_size + 0.5f * last * spacing);
}
