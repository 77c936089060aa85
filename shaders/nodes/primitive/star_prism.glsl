// Star prism: A star with straight edges, thick along z, with one tip on top.
// field: exact
// synonyms: sheriff star, solid star, christmas star
const float STAR_PRISM_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float star_prism_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * STAR_PRISM_PI - angle : angle;
    angle = x < 0.0f ? STAR_PRISM_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float star_prism_distance(
    vec3 p,
    int tips,            // 5 [2, 64] [2, 16]  Number of tips.
    float outer_radius,  // 0.8 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips.
    float inner_radius,  // 0.35 [0.001, 100] [0.05, 5] m  Distance from the centre to the corners between the tips.
    float depth)         // 0.3 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float half_sector = STAR_PRISM_PI / float(tips);
    float turn = floor(star_prism_angle(p.y, p.x) / (2.0f * half_sector) + 0.5f) * 2.0f * half_sector;
    vec2 q = vec2(p.y * cos(turn) + p.x * sin(turn), abs(p.x * cos(turn) - p.y * sin(turn)));
    vec2 edge = vec2(inner_radius * cos(half_sector) - outer_radius, inner_radius * sin(half_sector));
    vec2 from_tip = vec2(q.x - outer_radius, q.y);
    float along = clamp(dot(from_tip, edge) / max(dot(edge, edge), 1.0e-20f), 0.0f, 1.0f);
    float outline = length(from_tip - edge * along);
    float side = edge.x * from_tip.y - edge.y * from_tip.x > 0.0f ? -outline : outline;
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box star_prism_bounds(float outer_radius, float inner_radius, float depth)
{
    float radius = max(outer_radius, inner_radius);
    return make_box(vec3(0.0f), vec3(radius, radius, 0.5f * depth));
}
