// Rounded box: A block whose edges and corners are rounded off within its size.
// field: exact
// synonyms: round box, bevelled box, soft cube
float rounded_box_distance(
    vec3 p,
    vec3 half_size,  // (0.5, 0.5, 0.5) [0.001, 100] [0.05, 5] m  Half the length of the edges, rounding included.
    float rounding)  // 0.1 [0, 50] [0, 1] m  Radius of the edges, at most half the shortest side.
{
    float edge = min(rounding, min(half_size.x, min(half_size.y, half_size.z)));
    vec3 q = abs(p) - (half_size - vec3(edge));
    return length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f) - edge;
}

Box rounded_box_bounds(vec3 half_size)
{
    return make_box(vec3(0.0f), half_size);
}
