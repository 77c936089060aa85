// Gear 2D: A cogwheel with tapered teeth, one of them on top.
// field: exact
// synonyms: cog, cogwheel, sprocket, settings, teeth
const float GEAR_2D_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float gear_2d_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * GEAR_2D_PI - angle : angle;
    angle = x < 0.0f ? GEAR_2D_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// Squared distance from q to the segment along `edge` from the origin.
float gear_2d_edge(vec2 q, vec2 edge)
{
    vec2 away = q - edge * clamp(dot(q, edge) / max(dot(edge, edge), 1.0e-20f), 0.0f, 1.0f);
    return dot(away, away);
}

float gear_2d_distance(
    vec2 p,
    int teeth,       // 12 [3, 64]  Number of teeth.
    float radius,    // 0.6 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips of the teeth.
    float depth,     // 0.12 [0.001, 100] [0.01, 2] m  Depth of the gaps, at most half the radius.
    float share)     // 0.5 [0.2, 0.7]  Width of a tooth as a share of the way to the next one.
{
    float half_sector = GEAR_2D_PI / float(teeth);
    float turn = floor(gear_2d_angle(p.y, p.x) / (2.0f * half_sector) + 0.5f) * 2.0f * half_sector;
    vec2 q = vec2(p.y * cos(turn) + p.x * sin(turn), abs(p.x * cos(turn) - p.y * sin(turn)));
    float root = radius - min(depth, 0.5f * radius);
    float tip_angle = 0.75f * share * half_sector;
    float root_angle = 1.25f * share * half_sector;
    vec2 tip = radius * vec2(cos(tip_angle), sin(tip_angle));
    vec2 foot = root * vec2(cos(root_angle), sin(root_angle));
    float gap_distance = root * cos(half_sector - root_angle);
    vec2 gap = gap_distance * vec2(cos(half_sector), sin(half_sector));
    vec2 flank = foot - tip;
    vec2 floor_edge = gap - foot;
    float squared = gear_2d_edge(q - tip, vec2(0.0f, -tip.y));
    squared = min(squared, min(gear_2d_edge(q - tip, flank), gear_2d_edge(q - foot, floor_edge)));
    // Seen from the centre, each edge covers its own angle.
    bool before_tip = tip.x * q.y - tip.y * q.x < 0.0f;
    bool before_foot = foot.x * q.y - foot.y * q.x < 0.0f;
    float in_flank = flank.x * (q.y - tip.y) - flank.y * (q.x - tip.x);
    float in_gap = gap_distance - dot(q, gap) / gap_distance;
    float within = before_tip ? tip.x - q.x : (before_foot ? in_flank : in_gap);
    return within > 0.0f ? -sqrt(squared) : sqrt(squared);
}

Box gear_2d_bounds(float radius)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(radius, radius, 0.0f));
}
