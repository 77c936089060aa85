// Tapered box: A square block whose top is larger or smaller than its base.
// field: exact
// synonyms: truncated pyramid, square frustum, plinth, obelisk
// Distance to a square frustum; by symmetry p lies on the side of the face towards x.
float tapered_box_frustum(vec3 p, float bottom, float top, float height)
{
    vec3 q = vec3(max(abs(p.x), abs(p.z)), p.y, min(abs(p.x), abs(p.z)));
    float slant = length(vec2(height, bottom - top));
    vec2 rise = vec2(top - bottom, height) / slant;
    vec2 from_rim = vec2(q.x - bottom, q.y + 0.5f * height);
    float beyond = from_rim.x * rise.y - from_rim.y * rise.x;
    float up = clamp(dot(from_rim, rise), 0.0f, slant);
    vec2 to_face = from_rim - rise * up;
    bool on_face = q.z < bottom + (top - bottom) * (up / slant);
    vec3 edge = vec3(top - bottom, height, top - bottom);
    vec3 from_corner = vec3(from_rim.x, from_rim.y, q.z - bottom);
    vec3 to_edge = from_corner - edge * clamp(dot(from_corner, edge) / dot(edge, edge), 0.0f, 1.0f);
    float end_size = q.y < 0.0f ? bottom : top;
    vec3 cap = vec3(max(q.x - end_size, 0.0f), abs(q.y) - 0.5f * height, max(q.z - end_size, 0.0f));
    float squared = on_face ? dot(to_face, to_face) : dot(to_edge, to_edge);
    float nearest = sqrt(min(squared, dot(cap, cap)));
    return beyond < 0.0f && cap.y < 0.0f ? -nearest : nearest;
}

float tapered_box_distance(
    vec3 p,
    float bottom_half,  // 0.6 [0.001, 100] [0.05, 5] m  Half the length of the edges of the base.
    float top_half,     // 0.35 [0, 100] [0, 5] m  Half the length of the edges of the top.
    float height)       // 1.0 [0.001, 200] [0.05, 5] m  Distance from the base to the top.
{
    return tapered_box_frustum(p, bottom_half, top_half, height);
}

Box tapered_box_bounds(float bottom_half, float top_half, float height)
{
    float reach = max(bottom_half, top_half);
    return make_box(vec3(0.0f), vec3(reach, 0.5f * height, reach));
}
