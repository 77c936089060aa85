// Quad 3D: A thick sheet between four points, folded along the line from the first to the third.
// field: exact; bound
// synonyms: quadrilateral, face, sheet, four points
// Squared distance from the origin to a segment.
float quad_3d_edge(vec3 start, vec3 finish)
{
    vec3 along = finish - start;
    vec3 away = start + along * clamp(-dot(start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
    return dot(away, away);
}

// Squared distance from the origin to a triangle.
float quad_3d_face(vec3 a, vec3 b, vec3 c)
{
    vec3 facing = cross(b - a, c - a);
    float area = dot(facing, facing);
    float within_a = dot(cross(b - a, facing), a);
    float within_b = dot(cross(c - b, facing), b);
    float within_c = dot(cross(a - c, facing), c);
    float above = dot(facing, a);
    float edges = min(quad_3d_edge(a, b), min(quad_3d_edge(b, c), quad_3d_edge(c, a)));
    bool within = within_a > 0.0f && within_b > 0.0f && within_c > 0.0f && area > 1.0e-12f;
    return within ? min(above * above / max(area, 1.0e-12f), edges) : edges;
}

float quad_3d_distance(
    vec3 p,
    vec3 corner_a,     // (-0.7, -0.5, 0.2) [-1000, 1000] [-5, 5] m  First corner.
    vec3 corner_b,     // (0.7, -0.5, 0.2) [-1000, 1000] [-5, 5] m  Second corner.
    vec3 corner_c,     // (0.7, 0.5, -0.2) [-1000, 1000] [-5, 5] m  Third corner.
    vec3 corner_d,     // (-0.7, 0.5, -0.2) [-1000, 1000] [-5, 5] m  Fourth corner.
    float thickness)   // 0.1 [0.001, 50] [0.01, 0.5] m  Thickness of the sheet.
{
    float one = quad_3d_face(corner_a - p, corner_b - p, corner_c - p);
    float other = quad_3d_face(corner_a - p, corner_c - p, corner_d - p);
    return sqrt(min(one, other)) - 0.5f * thickness;
}

Box quad_3d_bounds(vec3 corner_a, vec3 corner_b, vec3 corner_c, vec3 corner_d, float thickness)
{
    vec3 low = min(min(corner_a, corner_b), min(corner_c, corner_d));
    vec3 high = max(max(corner_a, corner_b), max(corner_c, corner_d));
    return grow_box(make_box(0.5f * (low + high), 0.5f * (high - low)), 0.5f * thickness);
}
