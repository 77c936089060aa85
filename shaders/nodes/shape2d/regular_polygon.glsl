// Regular polygon: A polygon of equal sides with one corner on top.
// field: exact
// synonyms: ngon, triangle, pentagon, hexagon, octagon
const float REGULAR_POLYGON_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float regular_polygon_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * REGULAR_POLYGON_PI - angle : angle;
    angle = x < 0.0f ? REGULAR_POLYGON_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float regular_polygon_distance(
    vec2 p,
    int sides,     // 6 [3, 64]  Number of sides.
    float radius)  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the corners.
{
    float half_sector = REGULAR_POLYGON_PI / float(sides);
    float turn = (2.0f * floor(regular_polygon_angle(p.y, p.x) / (2.0f * half_sector)) + 1.0f) * half_sector;
    vec2 q = vec2(p.y * cos(turn) + p.x * sin(turn), p.x * cos(turn) - p.y * sin(turn));
    float half_side = radius * sin(half_sector);
    float beyond = q.x - radius * cos(half_sector);
    float outline = length(vec2(beyond, q.y - clamp(q.y, -half_side, half_side)));
    return beyond < 0.0f ? -outline : outline;
}

Box regular_polygon_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius, radius, 0.0f));
}
