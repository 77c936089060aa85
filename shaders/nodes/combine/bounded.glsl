// Bounded: Guards the first shape by the second: nothing shows beyond the guard and its margin, and far away the guard's
// distance counts. Put it above twisted, bent or displaced solids: rays take full steps until they are close. In a union
// the CPU leaves out what is guarded where something else is nearer than the guard.
// field: bound
// synonyms: guard, bounding volume, bounding box, limit, optimise, speed up, margin
// combiner: hard
float bounded_least(
    float b,
    float margin)  // 0.05 [0, 100] [0, 1] m  Room around the guard that the first shape may still fill.
{
    return b - margin;
}

float bounded_distance(float a, float b, float margin)
{
    return max(a, bounded_least(b, margin));
}

float bounded_blend(float a, float b)
{
    return 0.0f;
}

Box bounded_bounds(Box box_a, Box box_b, float margin)
{
    return overlap_boxes(box_a, grow_box(box_b, margin));
}
