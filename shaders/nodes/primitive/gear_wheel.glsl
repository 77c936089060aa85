// Gear wheel: A toothed wheel around the z axis with a hole.
// field: bound
// synonyms: gear, cog, cogwheel, sprocket
const float GEAR_WHEEL_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float gear_wheel_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * GEAR_WHEEL_PI - angle : angle;
    angle = x < 0.0f ? GEAR_WHEEL_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float gear_wheel_distance(
    vec3 p,
    int teeth,       // 12 [3, 128] [3, 48]  Number of teeth.
    float radius,    // 0.7 [0.001, 100] [0.05, 5] m  Distance from the axis to the bottom between the teeth.
    float tooth,     // 0.2 [0.001, 50] [0.01, 1] m  Height of the teeth.
    float hole,      // 0.2 [0, 100] [0, 2] m  Radius of the hole; 0 makes none.
    float thickness)  // 0.3 [0.001, 100] [0.05, 2] m  Thickness of the wheel.
{
    float half_sector = GEAR_WHEEL_PI / float(teeth);
    float turn = floor(gear_wheel_angle(p.y, p.x) / (2.0f * half_sector) + 0.5f) * 2.0f * half_sector;
    vec2 q = vec2(p.y * cos(turn) + p.x * sin(turn), abs(p.x * cos(turn) - p.y * sin(turn)));
    // The flanks lean in by a third of their height.
    float half_root = 0.55f * radius * sin(half_sector);
    float flank = 0.94868330f * (q.y - half_root) + 0.31622777f * (q.x - radius) * min(3.0f * half_root / tooth, 1.0f);
    float away = length(vec2(p.x, p.y));
    float outline = min(away - radius, max(q.x - radius - tooth, flank));
    outline = hole > 0.0f ? max(outline, hole - away) : outline;
    return max(outline, abs(p.z) - 0.5f * thickness);
}

Box gear_wheel_bounds(float radius, float tooth, float thickness)
{
    float reach = radius + tooth;
    return make_box(vec3(0.0f), vec3(1.2f * reach, 1.2f * reach, 0.5f * thickness));
}
