// Screw: A round rod along the y axis with a thread.
// field: bound
// synonyms: thread, bolt, threaded rod, worm
const float SCREW_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float screw_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * SCREW_PI - angle : angle;
    angle = x < 0.0f ? SCREW_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// Near the axis only the distance to the core counts: there the thread is too steep.
float screw_distance(
    vec3 p,
    float radius,  // 0.5 [0.01, 100] [0.05, 5] m  Distance from the axis to the ridge of the thread.
    float depth,   // 0.1 [0, 50] [0, 1] m  Depth of the thread, at most half the radius.
    float pitch,   // 0.3 [0.001, 100] [0.05, 5] m  Height of one turn.
    float height)  // 1.4 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float cut = min(depth, 0.5f * radius);
    float core = radius - cut;
    float away = length(vec2(p.x, p.z));
    float turns = p.y / pitch - screw_angle(p.x, p.z) / (2.0f * SCREW_PI);
    float ridge = 2.0f * abs(turns - floor(turns + 0.5f));
    float lean = length(vec2(1.0f, pitch / (SCREW_PI * core)));
    float slope = length(vec2(1.0f, 2.0f * cut / pitch * lean));
    float thread = (away - radius + cut * ridge) / slope;
    float side = min(away - core, max(thread, 0.5f * core - away));
    return max(side, abs(p.y) - 0.5f * height);
}

Box screw_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height, radius));
}
