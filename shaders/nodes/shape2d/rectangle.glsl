// Rectangle: A rectangle with sharp corners.
// field: exact
// synonyms: square, box 2d, quad
float rectangle_distance(
    vec2 p,
    vec2 half_size)  // (0.5, 0.3) [0.001, 100] [0.05, 5] m  Half the width and half the height.
{
    vec2 q = abs(p) - half_size;
    return length(max(q, vec2(0.0f))) + min(max(q.x, q.y), 0.0f);
}

Box rectangle_bounds(vec2 half_size)
{
    return make_box(vec3(0.0f), vec3(half_size.x, half_size.y, 0.0f));
}
