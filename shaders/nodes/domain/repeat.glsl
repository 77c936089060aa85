// Repeat: Fills space with copies of a solid, without end.
// Exact for solids that stay in their cell, and for symmetric ones that leave it by up to half a cell.
// field: exact; bound
// synonyms: tile, array, grid, infinite, lattice, clone
// copies: 8
// combiner: hard

// Along one axis: the cell that holds x, or (further is 1) the one on the nearer side of it.
float repeat_index(float x, float pitch, float further)
{
    float safe = max(pitch, 1.0e-6f);
    float index = floor(x / safe + 0.5f);
    float side = x < index * safe ? -1.0f : 1.0f;
    return pitch > 0.0f ? index + side * further : 0.0f;
}

vec3 repeat_cell(
    vec3 p,
    vec3 spacing,  // (2, 0, 2) [0, 1000] [0, 5] m  Distance between copies along x, y and z; 0 does not repeat.
    int copy)
{
    float index_x = repeat_index(p.x, spacing.x, float(copy % 2));
    int copy_yz = spacing.x > 0.0f ? copy / 2 : copy;
    float index_y = repeat_index(p.y, spacing.y, float(copy_yz % 2));
    int copy_z = spacing.y > 0.0f ? copy_yz / 2 : copy_yz;
    float index_z = repeat_index(p.z, spacing.z, float(copy_z % 2));
    return vec3(index_x, index_y, index_z);
}

vec3 repeat_point(vec3 p, vec3 spacing, int copy)
{
    return p - repeat_cell(p, spacing, copy) * spacing;
}

// Two along each axis that repeats.
int repeat_copies(vec3 spacing)
{
    return (spacing.x > 0.0f ? 2 : 1) * (spacing.y > 0.0f ? 2 : 1) * (spacing.z > 0.0f ? 2 : 1);
}

float repeat_distance(float acc, float d)
{
    return min(acc, d);
}

Box repeat_bounds(vec3 spacing, Box child)
{
    vec3 centre = vec3(spacing.x > 0.0f ? 0.0f : child.centre.x, spacing.y > 0.0f ? 0.0f : child.centre.y,
                       spacing.z > 0.0f ? 0.0f : child.centre.z);
    vec3 half_size = vec3(spacing.x > 0.0f ? UNBOUNDED : child.half_size.x,
                          spacing.y > 0.0f ? UNBOUNDED : child.half_size.y,
                          spacing.z > 0.0f ? UNBOUNDED : child.half_size.z);
    return make_box(centre, half_size);
}
