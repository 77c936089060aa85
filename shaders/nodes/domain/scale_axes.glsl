// Scale axes: Makes a solid larger or smaller, differently along x, y and z.
// field: bound
// point: affine
// synonyms: non-uniform scale, stretch, squash, squeeze, flatten
// combiner: hard
vec3 scale_axes_point(
    vec3 p,
    vec3 factors)  // (1.5, 0.6, 1) [0.001, 1000] [0.1, 5]  How many times as large along x, y and z.
{
    return p / factors;
}

// A step in the child's space is worth what it is along the axis that is scaled least.
float scale_axes_distance(float d, vec3 factors)
{
    return d * min(factors.x, min(factors.y, factors.z));
}

// An unbounded side stays so.
float scale_axes_extent(float extent, float factor)
{
    return extent >= UNBOUNDED ? UNBOUNDED : extent * factor;
}

Box scale_axes_bounds(vec3 factors, Box child)
{
    float x = scale_axes_extent(child.half_size.x, factors.x);
    float y = scale_axes_extent(child.half_size.y, factors.y);
    float z = scale_axes_extent(child.half_size.z, factors.z);
    return make_box(child.centre * factors, vec3(x, y, z));
}
