// Stairs 3D: A flight of solid steps that rise along x.
// field: exact
// synonyms: steps, staircase, flight, stadium seats
// Squared distance from q to a segment of the plane.
float stairs_3d_edge(vec2 q, vec2 start, vec2 finish)
{
    vec2 along = finish - start;
    vec2 from_start = q - start;
    vec2 away = from_start - along * clamp(dot(from_start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
    return dot(away, away);
}

float stairs_3d_distance(
    vec3 p,
    int steps,    // 5 [1, 256] [1, 16]  Number of steps.
    float run,    // 0.3 [0.001, 100] [0.05, 2] m  Depth of a step along x.
    float rise,   // 0.2 [0.001, 100] [0.05, 2] m  Height of a step.
    float depth)  // 1.0 [0.001, 200] [0.05, 5] m  Length of the steps along z.
{
    float count = float(steps);
    vec2 size = count * vec2(run, rise);
    vec2 q = vec2(p.x, p.y) + 0.5f * size;
    // The nearest tread lies below or above, the nearest riser beside, the nearest corners along the pitch line.
    float tread = clamp(floor(q.x / run), 0.0f, count - 1.0f);
    float riser = clamp(floor(q.y / rise), 0.0f, count - 1.0f);
    float pitch = (q.x * run + q.y * rise) / (run * run + rise * rise);
    float foot = clamp(floor(pitch + 0.5f), 0.0f, count);
    float nose = clamp(floor(pitch - rise * rise / (run * run + rise * rise) + 0.5f), 0.0f, count - 1.0f);
    float top = (tread + 1.0f) * rise;
    float squared = stairs_3d_edge(q, vec2(tread * run, top), vec2((tread + 1.0f) * run, top));
    vec2 riser_foot = riser * vec2(run, rise);
    squared = min(squared, stairs_3d_edge(q, riser_foot, riser_foot + vec2(0.0f, rise)));
    vec2 to_foot = q - foot * vec2(run, rise);
    vec2 to_nose = q - vec2(nose * run, (nose + 1.0f) * rise);
    squared = min(squared, min(dot(to_foot, to_foot), dot(to_nose, to_nose)));
    squared = min(squared, stairs_3d_edge(q, vec2(0.0f), vec2(size.x, 0.0f)));
    squared = min(squared, stairs_3d_edge(q, vec2(size.x, 0.0f), size));
    bool inside = q.x > 0.0f && q.x < size.x && q.y > 0.0f && q.y < top;
    float side = inside ? -sqrt(squared) : sqrt(squared);
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box stairs_3d_bounds(int steps, float run, float rise, float depth)
{
    return make_box(vec3(0.0f), 0.5f * vec3(float(steps) * run, float(steps) * rise, depth));
}
