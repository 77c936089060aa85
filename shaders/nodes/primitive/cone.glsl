// Cone: A cone or a truncated cone along the y axis with flat ends.
// field: exact
// synonyms: frustum, truncated cone, funnel, spike
float cone_distance(
    vec3 p,
    float bottom_radius,  // 0.5 [0, 100] [0, 5] m  Radius of the lower end.
    float top_radius,     // 0.0 [0, 100] [0, 5] m  Radius of the upper end; 0 makes a tip.
    float height)         // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float half_height = 0.5f * height;
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float end_radius = q.y < 0.0f ? bottom_radius : top_radius;
    vec2 cap = vec2(max(q.x - end_radius, 0.0f), abs(q.y) - half_height);
    vec2 edge = vec2(top_radius - bottom_radius, height);
    vec2 from_rim = vec2(q.x - bottom_radius, q.y + half_height);
    float along = clamp(dot(from_rim, edge) / dot(edge, edge), 0.0f, 1.0f);
    vec2 side = from_rim - edge * along;
    float nearest = sqrt(min(dot(cap, cap), dot(side, side)));
    float beside = from_rim.x * edge.y - from_rim.y * edge.x;
    return beside < 0.0f && cap.y < 0.0f ? -nearest : nearest;
}

Box cone_bounds(float bottom_radius, float top_radius, float height)
{
    float radius = max(bottom_radius, top_radius);
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height, radius));
}
