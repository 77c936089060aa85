// Wedge: A ramp that rises along x, with a flat base and an upright back.
// field: exact
// synonyms: ramp, slope, doorstop, right triangle
// Squared distance from q to a segment of the plane.
float wedge_edge(vec2 q, vec2 start, vec2 finish)
{
    vec2 along = finish - start;
    vec2 from_start = q - start;
    vec2 away = from_start - along * clamp(dot(from_start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
    return dot(away, away);
}

float wedge_distance(
    vec3 p,
    vec3 half_size)  // (0.7, 0.4, 0.5) [0.001, 100] [0.05, 5] m  Half the length, the height and the depth.
{
    vec2 size = vec2(half_size.x, half_size.y);
    vec2 q = vec2(p.x, p.y);
    float slope = wedge_edge(q, -size, size);
    float base = wedge_edge(q, -size, vec2(size.x, -size.y));
    float back = wedge_edge(q, vec2(size.x, -size.y), size);
    float outline = sqrt(min(slope, min(base, back)));
    bool inside = q.y > -size.y && q.x < size.x && q.y * size.x < q.x * size.y;
    float side = inside ? -outline : outline;
    float cap = abs(p.z) - half_size.z;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box wedge_bounds(vec3 half_size)
{
    return make_box(vec3(0.0f), half_size);
}
