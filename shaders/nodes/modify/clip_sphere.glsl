// Clip by sphere: Keeps of a solid what lies inside a sphere, or what lies outside of it.
// field: bound
// synonyms: cut, bite, scoop, crop, trim, ball
// combiner: hard
float clip_sphere_distance(
    vec3 p,
    float d,
    int keep,      // outside {inside, outside}  Which part stays.
    vec3 centre,   // (0.5, 0.5, 0.5) [-1000, 1000] [-5, 5] m  Middle of the sphere.
    float radius)  // 0.6 [0.001, 1000] [0.1, 5] m  Radius of the sphere.
{
    float ball = length(p - centre) - radius;
    return max(d, keep == 0 ? ball : -ball);
}

Box clip_sphere_bounds(int keep, vec3 centre, float radius, Box child)
{
    Box inside = overlap_boxes(child, make_box(centre, vec3(radius)));
    return make_box(keep == 0 ? inside.centre : child.centre, keep == 0 ? inside.half_size : child.half_size);
}
