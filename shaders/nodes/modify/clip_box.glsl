// Clip by box: Keeps of a solid what lies inside a box, or what lies outside of it.
// field: bound
// synonyms: cut, crop, trim, section, window, corner
// combiner: hard
float clip_box_distance(
    vec3 p,
    float d,
    int keep,        // outside {inside, outside}  Which part stays.
    vec3 centre,     // (0.5, 0.5, 0.5) [-1000, 1000] [-5, 5] m  Middle of the box.
    vec3 half_size)  // (0.5, 0.5, 0.5) [0.001, 1000] [0.1, 5] m  Half the box's width, height and depth.
{
    vec3 q = abs(p - centre) - half_size;
    float box = length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f);
    return max(d, keep == 0 ? box : -box);
}

Box clip_box_bounds(int keep, vec3 centre, vec3 half_size, Box child)
{
    Box inside = overlap_boxes(child, make_box(centre, half_size));
    return make_box(keep == 0 ? inside.centre : child.centre, keep == 0 ? inside.half_size : child.half_size);
}
