// Custom shape: a rounded box, yours to change.
// field: exact
float custom_shape_distance(
    vec3 p,
    vec3 size,        // (0.6, 0.4, 0.5) [0.01, 100] [0.1, 2] m  Half the width, height and depth, without the rounding.
    float roundness)  // 0.1 [0, 10] [0, 0.5] m  Radius of edges and corners.
{
    vec3 q = abs(p) - size;
    return length(max(q, vec3(0.0f))) + min(max(q.x, max(q.y, q.z)), 0.0f) - roundness;
}

// A box around the surface.
Box custom_shape_bounds(vec3 size, float roundness)
{
    return make_box(vec3(0.0f), size + vec3(roundness));
}
