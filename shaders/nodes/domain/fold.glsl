// Fold: Folds space back at the faces of a box, so that a solid shows again, mirrored, on each side of it.
// field: bound
// synonyms: box fold, reflect, mirror, fractal, mandelbox
vec3 fold_point(
    vec3 p,
    vec3 half_size)  // (0.7, 5, 0.7) [0.001, 1000] [0.1, 5] m  Half the box's width, height and depth.
{
    return 2.0f * clamp(p, -half_size, half_size) - p;
}

Box fold_bounds(vec3 half_size, Box child)
{
    vec3 low = child.centre - child.half_size;
    vec3 high = child.centre + child.half_size;
    vec3 lowest = min(low, -2.0f * half_size - high);
    vec3 highest = max(high, 2.0f * half_size - low);
    return make_box(0.5f * (lowest + highest), 0.5f * (highest - lowest));
}
