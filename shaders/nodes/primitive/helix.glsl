// Helix: A wire wound around the y axis, such as a coil spring.
// field: bound
// synonyms: spring, coil, spiral, corkscrew
const float HELIX_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float helix_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * HELIX_PI - angle : angle;
    angle = x < 0.0f ? HELIX_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// The wire is near the axis nowhere: inside the middle of its clearance only the distance to the hollow counts.
float helix_distance(
    vec3 p,
    float major,   // 0.5 [0.01, 100] [0.05, 5] m  Distance from the axis to the middle of the wire.
    float minor,   // 0.08 [0.001, 50] [0.01, 1] m  Radius of the wire, at most half the distance to the axis.
    float pitch,   // 0.4 [0.001, 100] [0.05, 5] m  Height of one turn.
    float height)  // 1.6 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float wire = min(minor, 0.5f * major);
    float hollow = 0.5f * (major - wire);
    float rise = pitch / (2.0f * HELIX_PI);
    float away = length(vec2(p.x, p.z));
    float turns = (p.y - rise * helix_angle(p.x, p.z)) / pitch;
    float above = (turns - floor(turns + 0.5f)) * pitch * major / length(vec2(major, rise));
    float slope = major / length(vec2(major, rise)) * length(vec2(hollow, rise)) / hollow;
    float coil = (length(vec2(away - major, above)) - wire) / max(slope, 1.0f);
    coil = max(2.0f * hollow - away, min(coil, away - hollow));
    float side = away - major - wire;
    float cap = abs(p.y) - 0.5f * height;
    float around = length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
    return max(coil, around);
}

Box helix_bounds(float major, float minor, float height)
{
    float reach = major + min(minor, 0.5f * major);
    return make_box(vec3(0.0f), vec3(reach, 0.5f * height, reach));
}
