// Repeat hexagonal: Covers the ground with copies of a solid, arranged like the cells of a honeycomb.
// Exact for solids that stay in their cell, and for symmetric ones that leave it by up to half a cell.
// field: exact; bound
// synonyms: honeycomb, hex grid, triangular lattice, tile, array
// copies: 7
// combiner: hard
const float REPEAT_HEXAGONAL_ROW = 0.866025404f;

// The nearest cell: steps along x, and rows, each of which begins half a step further.
vec2 repeat_hexagonal_nearest(vec2 q)
{
    vec2 even = floor(vec2(q.x, q.y / (2.0f * REPEAT_HEXAGONAL_ROW)) + vec2(0.5f));
    vec2 odd = floor(vec2(q.x, q.y / (2.0f * REPEAT_HEXAGONAL_ROW)));
    vec2 from_even = q - vec2(even.x, even.y * 2.0f * REPEAT_HEXAGONAL_ROW);
    vec2 from_odd = q - vec2(odd.x + 0.5f, (2.0f * odd.y + 1.0f) * REPEAT_HEXAGONAL_ROW);
    bool is_odd = dot(from_odd, from_odd) < dot(from_even, from_even);
    return is_odd ? vec2(odd.x - odd.y, 2.0f * odd.y + 1.0f) : vec2(even.x - even.y, 2.0f * even.y);
}

// Copy 0 is the cell itself, the others lie around it.
vec2 repeat_hexagonal_neighbour(int copy)
{
    float side = copy > 3 ? -1.0f : 1.0f;
    int turn = copy > 3 ? copy - 3 : copy;
    vec2 step_to = turn == 1 ? vec2(1.0f, 0.0f) : (turn == 2 ? vec2(0.0f, 1.0f) : vec2(-1.0f, 1.0f));
    return copy == 0 ? vec2(0.0f) : side * step_to;
}

vec3 repeat_hexagonal_cell(
    vec3 p,
    float spacing,  // 1.5 [0.001, 1000] [0.1, 5] m  Distance from copy to copy.
    int copy)
{
    vec2 cell = repeat_hexagonal_nearest(vec2(p.x, p.z) / spacing) + repeat_hexagonal_neighbour(copy);
    return vec3(cell.x, 0.0f, cell.y);
}

vec3 repeat_hexagonal_point(vec3 p, float spacing, int copy)
{
    vec3 cell = repeat_hexagonal_cell(p, spacing, copy);
    return p - vec3(cell.x + 0.5f * cell.z, 0.0f, cell.z * REPEAT_HEXAGONAL_ROW) * spacing;
}

float repeat_hexagonal_distance(float acc, float d)
{
    return min(acc, d);
}

Box repeat_hexagonal_bounds(Box child)
{
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(UNBOUNDED, child.half_size.y, UNBOUNDED));
}
