// Triangle 2D: A triangle between any three points.
// field: exact
// synonyms: free triangle, three points, scalene
// Squared distance from q to the segment along `edge` from the origin.
float triangle_2d_edge(vec2 q, vec2 edge)
{
    vec2 away = q - edge * clamp(dot(q, edge) / max(dot(edge, edge), 1.0e-20f), 0.0f, 1.0f);
    return dot(away, away);
}

float triangle_2d_distance(
    vec2 p,
    vec2 first,   // (-0.5, -0.4) [-100, 100] [-2, 2] m  First corner.
    vec2 second,  // (0.6, -0.2) [-100, 100] [-2, 2] m  Second corner.
    vec2 third)   // (-0.1, 0.5) [-100, 100] [-2, 2] m  Third corner.
{
    vec2 edge_a = second - first;
    vec2 edge_b = third - second;
    vec2 edge_c = first - third;
    vec2 qa = p - first;
    vec2 qb = p - second;
    vec2 qc = p - third;
    float squared = min(min(triangle_2d_edge(qa, edge_a), triangle_2d_edge(qb, edge_b)), triangle_2d_edge(qc, edge_c));
    float turn = edge_a.x * edge_b.y - edge_a.y * edge_b.x < 0.0f ? -1.0f : 1.0f;
    float side_a = turn * (edge_a.x * qa.y - edge_a.y * qa.x);
    float side_b = turn * (edge_b.x * qb.y - edge_b.y * qb.x);
    float side_c = turn * (edge_c.x * qc.y - edge_c.y * qc.x);
    return min(min(side_a, side_b), side_c) > 0.0f ? -sqrt(squared) : sqrt(squared);
}

Box triangle_2d_bounds(vec2 first, vec2 second, vec2 third)
{
    vec2 low = min(min(first, second), third);
    vec2 high = max(max(first, second), third);
    vec2 centre = 0.5f * (low + high);
    vec2 reach = 0.5f * (high - low);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
