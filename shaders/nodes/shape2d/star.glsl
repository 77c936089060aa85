// Star: A star with straight edges and one tip on top.
// field: exact
// synonyms: pentagram, asterisk, spikes
const float STAR_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float star_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * STAR_PI - angle : angle;
    angle = x < 0.0f ? STAR_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float star_distance(
    vec2 p,
    int tips,             // 5 [2, 64]  Number of tips.
    float outer_radius,   // 0.6 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips.
    float inner_radius)   // 0.25 [0.001, 100] [0.05, 5] m  Distance from the centre to the corners between the tips.
{
    float half_sector = STAR_PI / float(tips);
    float turn = floor(star_angle(p.y, p.x) / (2.0f * half_sector) + 0.5f) * 2.0f * half_sector;
    vec2 q = vec2(p.y * cos(turn) + p.x * sin(turn), abs(p.x * cos(turn) - p.y * sin(turn)));
    vec2 edge = vec2(inner_radius * cos(half_sector) - outer_radius, inner_radius * sin(half_sector));
    vec2 from_tip = vec2(q.x - outer_radius, q.y);
    float along = clamp(dot(from_tip, edge) / max(dot(edge, edge), 1.0e-20f), 0.0f, 1.0f);
    float outline = length(from_tip - edge * along);
    return edge.x * from_tip.y - edge.y * from_tip.x > 0.0f ? -outline : outline;
}

Box star_bounds(float outer_radius, float inner_radius)
{
    float radius = max(outer_radius, inner_radius);
    return make_box(vec3(0.0f), vec3(radius, radius, 0.0f));
}
