// Cone between points: A cone or a truncated cone with flat ends from one point to another.
// field: exact
// synonyms: capped cone, frustum between, arrow head
// Coordinates of p along the line from start and away from it: (away, along, length of the line).
vec3 cone_between_place(vec3 p, vec3 start, vec3 finish)
{
    vec3 line = finish - start;
    float size = length(line);
    vec3 axis = size > 1.0e-6f ? line / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    float along = dot(p - start, axis);
    return vec3(length(p - start - axis * along), along, size);
}

float cone_between_distance(
    vec3 p,
    vec3 start,           // (-0.5, -0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it begins.
    vec3 finish,          // (0.5, 0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it ends.
    float start_radius,   // 0.5 [0, 100] [0, 5] m  Radius of the end at the start.
    float finish_radius)  // 0.15 [0, 100] [0, 5] m  Radius of the end at the finish; 0 makes a tip.
{
    vec3 place = cone_between_place(p, start, finish);
    float end_radius = place.y < 0.5f * place.z ? start_radius : finish_radius;
    vec2 cap = vec2(max(place.x - end_radius, 0.0f), abs(place.y - 0.5f * place.z) - 0.5f * place.z);
    vec2 edge = vec2(finish_radius - start_radius, place.z);
    vec2 from_rim = vec2(place.x - start_radius, place.y);
    float along = clamp(dot(from_rim, edge) / max(dot(edge, edge), 1.0e-12f), 0.0f, 1.0f);
    vec2 side = from_rim - edge * along;
    float nearest = sqrt(min(dot(cap, cap), dot(side, side)));
    float beside = from_rim.x * edge.y - from_rim.y * edge.x;
    return beside < 0.0f && cap.y < 0.0f ? -nearest : nearest;
}

Box cone_between_bounds(vec3 start, vec3 finish, float start_radius, float finish_radius)
{
    return make_box(0.5f * (start + finish), 0.5f * abs(finish - start) + vec3(max(start_radius, finish_radius)));
}
