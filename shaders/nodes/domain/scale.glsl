// Scale: Makes a solid larger or smaller, the same along all axes.
// field: exact
// point: affine
// synonyms: size, resize, zoom, enlarge, shrink
// combiner: hard
vec3 scale_point(
    vec3 p,
    float factor)  // 1.5 [0.001, 1000] [0.1, 5]  How many times as large.
{
    return p / factor;
}

float scale_distance(float d, float factor)
{
    return d * factor;
}

// An unbounded side stays so.
float scale_extent(float extent, float factor)
{
    return extent >= UNBOUNDED ? UNBOUNDED : extent * factor;
}

Box scale_bounds(float factor, Box child)
{
    vec3 half_size = vec3(scale_extent(child.half_size.x, factor), scale_extent(child.half_size.y, factor),
                          scale_extent(child.half_size.z, factor));
    return make_box(child.centre * factor, half_size);
}
