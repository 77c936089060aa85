// X shape: Two crossed diagonal strokes with round ends.
// field: exact; bound
// synonyms: rounded x, cross mark, close, multiply, saltire
float x_shape_distance(
    vec2 p,
    float half_size,  // 0.4 [0.001, 100] [0.05, 5] m  How far the strokes go along x and y, without their ends.
    float thickness)  // 0.2 [0.001, 100] [0.01, 2] m  Width of the strokes.
{
    vec2 q = abs(p);
    float along = min(0.5f * (q.x + q.y), half_size);
    return length(vec2(q.x - along, q.y - along)) - 0.5f * thickness;
}

Box x_shape_bounds(float half_size, float thickness)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_size + 0.5f * thickness, half_size + 0.5f * thickness, 0.0f));
}
