// Repeat 1D: A row of copies of a solid, centred on the origin.
// Exact for solids that stay in their cell, and for symmetric ones that leave it by up to half a cell.
// field: exact; bound
// synonyms: row, line, fence, copies, clone, array
// copies: 2
// combiner: hard

// The cell that holds x, or (further is 1) the one on the nearer side of it.
float repeat_1d_index(float x, float pitch, float last, float further)
{
    float index = clamp(floor(x / pitch + 0.5f * last + 0.5f), 0.0f, last);
    float side = x < (index - 0.5f * last) * pitch ? -1.0f : 1.0f;
    // At the ends there is no further copy on that side; the one before takes its turn.
    float next = index + side;
    next = next < 0.0f || next > last ? index - side : next;
    return further > 0.5f ? clamp(next, 0.0f, last) : index;
}

vec3 repeat_1d_cell(
    vec3 p,
    int axis,       // x {x, y, z}  Direction of the row.
    float spacing,  // 1.2 [0.001, 1000] [0.1, 5] m  Distance from copy to copy.
    int count,      // 3 [1, 10000] [1, 20]  Number of copies.
    int copy)
{
    float x = axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
    float index = repeat_1d_index(x, spacing, float(count - 1), float(copy));
    return vec3(axis == 0 ? index : 0.0f, axis == 1 ? index : 0.0f, axis == 2 ? index : 0.0f);
}

vec3 repeat_1d_point(vec3 p, int axis, float spacing, int count, int copy)
{
    float middle = 0.5f * float(count - 1);
    vec3 first = vec3(axis == 0 ? middle : 0.0f, axis == 1 ? middle : 0.0f, axis == 2 ? middle : 0.0f);
    return p - (repeat_1d_cell(p, axis, spacing, count, copy) - first) * spacing;
}

float repeat_1d_distance(float acc, float d)
{
    return min(acc, d);
}

Box repeat_1d_bounds(int axis, float spacing, int count, Box child)
{
    float reach = 0.5f * float(count - 1) * spacing;
    vec3 more = vec3(axis == 0 ? reach : 0.0f, axis == 1 ? reach : 0.0f, axis == 2 ? reach : 0.0f);
    return make_box(child.centre, child.half_size + more);
}
