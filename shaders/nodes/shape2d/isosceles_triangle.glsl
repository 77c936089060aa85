// Isosceles triangle: A symmetric triangle that stands on its base.
// field: exact
// synonyms: gable, roof, wedge, spike
float isosceles_triangle_distance(
    vec2 p,
    float half_width,  // 0.4 [0.001, 100] [0.05, 5] m  Half the length of the base.
    float height)      // 0.9 [0.001, 200] [0.1, 10] m  Height from the base to the tip.
{
    vec2 q = vec2(abs(p.x), p.y + 0.5f * height);
    vec2 edge = vec2(-half_width, height);
    vec2 from_corner = vec2(q.x - half_width, q.y);
    vec2 from_edge = from_corner - edge * clamp(dot(from_corner, edge) / dot(edge, edge), 0.0f, 1.0f);
    vec2 from_base = vec2(max(from_corner.x, 0.0f), q.y);
    float outline = sqrt(min(dot(from_edge, from_edge), dot(from_base, from_base)));
    return edge.x * from_corner.y - edge.y * from_corner.x > 0.0f && q.y > 0.0f ? -outline : outline;
}

Box isosceles_triangle_bounds(float half_width, float height)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_width, 0.5f * height, 0.0f));
}
