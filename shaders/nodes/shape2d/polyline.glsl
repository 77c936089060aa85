// Polyline: A stroke through a list of points, with round joints and ends. At most 64 points are drawn.
// field: exact; bound
// synonyms: path, line strip, zigzag, curve
float polyline_distance(
    vec2 p,
    List points,      // [(-0.7, -0.4), (-0.2, 0.4), (0.2, -0.4), (0.7, 0.4)] [-100, 100] m  Points of the path.
    bool closed,      // false  Join the last point to the first.
    float thickness)  // 0.15 [0.001, 100] [0.01, 2] m  Width of the stroke.
{
    float squared = 1.0e12f;
    for (int i = 0; i < 64; i++) {
        if (i >= points.count) {
            break;
        }
        int last = closed ? 0 : i;
        int next = i + 1 < points.count && i + 1 < 64 ? i + 1 : last;
        vec4 start = list_at(points, i);
        vec4 finish = list_at(points, next);
        vec2 along = vec2(finish.x - start.x, finish.y - start.y);
        vec2 from_start = vec2(p.x - start.x, p.y - start.y);
        float share = clamp(dot(from_start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
        vec2 away = from_start - along * share;
        squared = min(squared, dot(away, away));
    }
    return sqrt(squared) - 0.5f * thickness;
}

Box polyline_bounds(List points, float thickness)
{
    vec2 low = vec2(UNBOUNDED);
    vec2 high = vec2(-UNBOUNDED);
    for (int i = 0; i < 64; i++) {
        if (i >= points.count) {
            break;
        }
        vec4 corner = list_at(points, i);
        low = min(low, vec2(corner.x, corner.y));
        high = max(high, vec2(corner.x, corner.y));
    }
    high = max(high, low);
    vec2 centre = points.count > 0 ? 0.5f * (low + high) : vec2(0.0f);
    vec2 reach = 0.5f * (high - low) + vec2(0.5f * thickness);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
