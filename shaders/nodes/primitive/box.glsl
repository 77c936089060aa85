// Box: A block with sharp edges.
// field: exact
// synonyms: cube, cuboid, block
float box_distance(
    vec3 p,
    vec3 half_size)  // (0.5, 0.5, 0.5) [0.001, 100] [0.05, 5] m  Half the length of the edges along x, y and z.
{
    vec3 q = abs(p) - half_size;
    return length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f);
}

Box box_bounds(vec3 half_size)
{
    return make_box(vec3(0.0f), half_size);
}
