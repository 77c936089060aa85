// Scale 2D: Makes a flat shape larger or smaller, the same along both axes.
// field: exact
// synonyms: size, resize, zoom, enlarge, shrink
// combiner: hard
vec2 scale_2d_point(
    vec2 p,
    float factor)  // 1.5 [0.001, 1000] [0.1, 5]  How many times as large.
{
    return p / factor;
}

float scale_2d_distance(float d, float factor)
{
    return d * factor;
}

// An unbounded side stays so.
float scale_2d_extent(float extent, float factor)
{
    return extent >= UNBOUNDED ? UNBOUNDED : extent * factor;
}

Box scale_2d_bounds(float factor, Box child)
{
    vec3 half_size = vec3(scale_2d_extent(child.half_size.x, factor), scale_2d_extent(child.half_size.y, factor),
                          child.half_size.z);
    return make_box(child.centre * factor, half_size);
}
