// Box frame: The twelve edges of a block as square bars.
// field: exact; bound
// synonyms: wire cube, cage, edges, lattice
float box_frame_distance(
    vec3 p,
    vec3 half_size,   // (0.5, 0.5, 0.5) [0.001, 100] [0.05, 5] m  Half the length of the outer edges.
    float thickness)  // 0.1 [0.001, 50] [0.01, 0.5] m  Width of the bars, at most the shortest half edge.
{
    float bar = 0.5f * min(thickness, min(half_size.x, min(half_size.y, half_size.z)));
    vec3 q = abs(p) - half_size;
    vec3 w = abs(q + vec3(bar)) - vec3(bar);
    vec3 q_out = max(q, vec3(0.0f));
    vec3 w_out = max(w, vec3(0.0f));
    float along_x = length(vec3(q_out.x, w_out.y, w_out.z)) + min(max(q.x, max(w.y, w.z)), 0.0f);
    float along_y = length(vec3(w_out.x, q_out.y, w_out.z)) + min(max(w.x, max(q.y, w.z)), 0.0f);
    float along_z = length(vec3(w_out.x, w_out.y, q_out.z)) + min(max(w.x, max(w.y, q.z)), 0.0f);
    return min(along_x, min(along_y, along_z));
}

Box box_frame_bounds(vec3 half_size)
{
    return make_box(vec3(0.0f), half_size);
}
