// Polygon: A filled outline through a list of points. Where it crosses itself, every second part is empty.
// At most 64 points are drawn.
// field: exact
// synonyms: closed polygon, free form, outline, shape, points
float polygon_distance(
    vec2 p,
    List points)  // [(-0.6, -0.4), (0.5, -0.5), (0.6, 0.1), (0.1, 0.05), (-0.3, 0.5)] [-100, 100] m  Corners.
{
    float squared = 1.0e12f;
    bool inside = false;
    for (int i = 0; i < 64; i++) {
        if (i >= points.count) {
            break;
        }
        int next = i + 1 < points.count && i + 1 < 64 ? i + 1 : 0;
        vec4 start = list_at(points, i);
        vec4 finish = list_at(points, next);
        vec2 along = vec2(finish.x - start.x, finish.y - start.y);
        vec2 from_start = vec2(p.x - start.x, p.y - start.y);
        float share = clamp(dot(from_start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
        vec2 away = from_start - along * share;
        squared = min(squared, dot(away, away));
        // A ray to the right crosses the edges that pass its height on that side.
        bool passes = (start.y > p.y) != (finish.y > p.y);
        float side = along.x * from_start.y - along.y * from_start.x;
        bool to_the_right = along.y > 0.0f ? side > 0.0f : side < 0.0f;
        inside = passes && to_the_right ? !inside : inside;
    }
    return inside ? -sqrt(squared) : sqrt(squared);
}

Box polygon_bounds(List points)
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
    vec2 reach = 0.5f * (high - low);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
