// Rounded cone between points: Two balls of any size and the cone that wraps both.
// field: exact
// synonyms: round cone between, tapered capsule, limb
// Coordinates of p along the line from start and away from it: (away, along, length of the line).
vec3 rounded_cone_between_place(vec3 p, vec3 start, vec3 finish)
{
    vec3 line = finish - start;
    float size = length(line);
    vec3 axis = size > 1.0e-6f ? line / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    float along = dot(p - start, axis);
    return vec3(length(p - start - axis * along), along, size);
}

// Two discs in the plane of (away, along) and the tangent between them.
float rounded_cone_between_profile(vec2 q, float start_radius, float finish_radius, float size)
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

float rounded_cone_between_distance(
    vec3 p,
    vec3 start,           // (-0.5, -0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it begins.
    vec3 finish,          // (0.5, 0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it ends.
    float start_radius,   // 0.4 [0.001, 100] [0.05, 5] m  Radius of the ball at the start.
    float finish_radius)  // 0.2 [0.001, 100] [0.05, 5] m  Radius of the ball at the finish.
{
    vec3 place = rounded_cone_between_place(p, start, finish);
    return rounded_cone_between_profile(vec2(place.x, place.y), start_radius, finish_radius, place.z);
}

Box rounded_cone_between_bounds(vec3 start, vec3 finish, float start_radius, float finish_radius)
{
    return join_boxes(make_box(start, vec3(start_radius)), make_box(finish, vec3(finish_radius)));
}
