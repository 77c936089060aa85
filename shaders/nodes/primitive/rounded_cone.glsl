// Rounded cone: A ball below, a ball above it, and the cone that wraps both.
// field: exact
// synonyms: round cone, drop, snowman, pear
// Two discs in the plane of (away, along) and the tangent between them.
float rounded_cone_profile(vec2 q, float start_radius, float finish_radius, float size)
{
    float slope = (start_radius - finish_radius) / max(size, 1.0e-6f);
    float to_start = length(q) - start_radius;
    float to_finish = length(vec2(q.x, q.y - size)) - finish_radius;
    float rise = sqrt(max(1.0f - slope * slope, 0.0f));
    float along = q.y * rise - q.x * slope;
    float beside = q.x * rise + q.y * slope - start_radius;
    float between = along < 0.0f ? to_start : along > rise * size ? to_finish : beside;
    return abs(slope) >= 1.0f ? min(to_start, to_finish) : between;
}

float rounded_cone_distance(
    vec3 p,
    float bottom_radius,  // 0.5 [0.001, 100] [0.05, 5] m  Radius of the lower ball.
    float top_radius,     // 0.2 [0.001, 100] [0.05, 5] m  Radius of the upper ball.
    float height)         // 0.8 [0, 200] [0, 5] m  Distance between the centres of the balls.
{
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y + 0.5f * height);
    return rounded_cone_profile(q, bottom_radius, top_radius, height);
}

Box rounded_cone_bounds(float bottom_radius, float top_radius, float height)
{
    vec3 centre = vec3(0.0f, 0.5f * height, 0.0f);
    return join_boxes(make_box(-centre, vec3(bottom_radius)), make_box(centre, vec3(top_radius)));
}
