// Bounded: Guards a field by a box: nothing shows beyond the box and its margin, and far away its distance counts.
// Put it above twisted, bent or displaced solids: rays take full steps until they are close.
// field: bound
// synonyms: guard, bounding box, limit, optimise, speed up, margin
// combiner: hard
float bounded_distance(
    vec3 p,
    float d,
    vec3 centre,     // (0, 0, 0) [-1000, 1000] [-5, 5] m  Middle of the box.
    vec3 half_size,  // (0.75, 0.75, 0.75) [0.001, 1000] [0.1, 5] m  Half the box's width, height and depth.
    float margin)    // 0.05 [0, 100] [0, 1] m  Room around the box that the solid may still fill.
{
    vec3 q = abs(p - centre) - half_size;
    float box = length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f);
    return max(d, box - margin);
}

Box bounded_bounds(vec3 centre, vec3 half_size, float margin, Box child)
{
    return overlap_boxes(child, make_box(centre, half_size + vec3(margin)));
}
