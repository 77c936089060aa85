// Morph: A shape between two shapes.
// field: bound
// synonyms: mix, interpolate, tween, blend, lerp
// combiner: hard
float morph_distance(
    float a,
    float b,
    float amount)  // 0.5 [0, 1]  How far on the way: 0 is the first shape, 1 the second.
{
    return mix(a, b, amount);
}

float morph_blend(float amount)
{
    return amount;
}

Box morph_bounds(Box box_a, Box box_b)
{
    return join_boxes(box_a, box_b);
}
