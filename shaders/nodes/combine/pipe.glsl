// Pipe: A tube along the line where the two surfaces cross.
// field: bound
// synonyms: tube, cord, weld bead, intersection curve, seam
float pipe_distance(
    float a,
    float b,
    float radius)  // 0.12 [0.001, 10] [0.01, 1] m  Radius of the tube.
{
    return length(vec2(a, b)) - radius;
}

// Where both surfaces face the same way, both distances change at once.
float pipe_lipschitz()
{
    return 1.41421357f;
}

float pipe_blend(float a, float b)
{
    return abs(b) < abs(a) ? 1.0f : 0.0f;
}

bool pipe_shows_b(float a, float b)
{
    return abs(b) < abs(a);
}

Box pipe_bounds(Box box_a, Box box_b, float radius)
{
    return overlap_boxes(grow_box(box_a, radius), grow_box(box_b, radius));
}
