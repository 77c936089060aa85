// Prism: A column along the y axis with any number of equal sides.
// field: exact
// synonyms: n-sided prism, polygon column, pentagonal prism, pillar
const float PRISM_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float prism_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * PRISM_PI - angle : angle;
    angle = x < 0.0f ? PRISM_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float prism_distance(
    vec3 p,
    int sides,     // 5 [3, 64] [3, 16]  Number of sides.
    float radius,  // 0.6 [0.001, 100] [0.05, 5] m  Distance from the axis to the edges.
    float height)  // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float half_sector = PRISM_PI / float(sides);
    float turn = (2.0f * floor(prism_angle(p.z, p.x) / (2.0f * half_sector)) + 1.0f) * half_sector;
    vec2 q = vec2(p.z * cos(turn) + p.x * sin(turn), p.x * cos(turn) - p.z * sin(turn));
    float half_side = radius * sin(half_sector);
    float beyond = q.x - radius * cos(half_sector);
    float outline = length(vec2(beyond, q.y - clamp(q.y, -half_side, half_side)));
    float side = beyond < 0.0f ? beyond : outline;
    float cap = abs(p.y) - 0.5f * height;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box prism_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height, radius));
}
