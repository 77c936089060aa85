// Torus knot: A tube that winds around the y axis and around a ring at once. Two windings without a common divisor make
// one closed knot; others make several rings.
// field: bound
// synonyms: trefoil, knot, celtic, braid
const float TORUS_KNOT_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float torus_knot_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * TORUS_KNOT_PI - angle : angle;
    angle = x < 0.0f ? TORUS_KNOT_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float torus_knot_distance(
    vec3 p,
    float major,   // 0.7 [0.01, 100] [0.05, 5] m  Distance from the centre to the middle of the ring.
    float minor,   // 0.3 [0.001, 100] [0.01, 2] m  Distance from the ring to the tube's middle, less than that.
    float tube,    // 0.12 [0.001, 50] [0.01, 1] m  Radius of the tube.
    int around,    // 2 [1, 16] [1, 8]  How often the tube goes round the y axis.
    int through)   // 3 [0, 32] [0, 12]  How often the tube goes through the middle.
{
    float lever = min(minor, 0.7f * major);
    float wire = min(tube, 0.9f * (major - lever));
    float hollow = 0.5f * (major - lever - wire);
    float away = length(vec2(p.x, p.z));
    vec2 q = vec2(away - major, p.y);
    float part = 2.0f * TORUS_KNOT_PI / float(around);
    float lead = float(through) / float(around);
    float turn = torus_knot_angle(q.x, q.y) - lead * torus_knot_angle(p.x, p.z);
    turn = turn - part * floor(turn / part + 0.5f);
    float ring = length(q);
    float strand = length(vec2(ring * cos(turn) - lever, ring * sin(turn))) - wire;
    float slope = length(vec2(1.0f, lead * lever / hollow));
    return max(ring - lever - wire, min(strand / slope, away - hollow));
}

Box torus_knot_bounds(float major, float minor, float tube)
{
    float lever = min(minor, 0.7f * major);
    float reach = lever + min(tube, 0.9f * (major - lever));
    return make_box(vec3(0.0f), vec3(major + reach, reach, major + reach));
}
