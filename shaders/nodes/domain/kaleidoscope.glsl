// Kaleidoscope: Mirrors a wedge around the y axis over and over, as two mirrors at an angle do.
// What leaves the wedge is cut there.
// field: bound
// synonyms: polar mirror, radial symmetry, snowflake, mandala, rosette
const float KALEIDOSCOPE_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float kaleidoscope_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * KALEIDOSCOPE_PI - angle : angle;
    angle = x < 0.0f ? KALEIDOSCOPE_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

vec3 kaleidoscope_point(
    vec3 p,
    int count,     // 6 [1, 256] [2, 24]  Number of wedge pairs around the axis.
    float radius,  // 0.9 [0, 1000] [0, 5] m  How far the solid is moved out along x first.
    float spin)    // 25.0 [-3600, 3600] [-180, 180] deg  Turn of the solid around its own y axis.
{
    float sector = 2.0f * KALEIDOSCOPE_PI / float(count);
    float turn = floor(kaleidoscope_angle(p.x, p.z) / sector + 0.5f) * sector;
    float out_along = p.x * cos(turn) + p.z * sin(turn) - radius;
    float across = abs(p.z * cos(turn) - p.x * sin(turn));
    return vec3(out_along * cos(spin) + across * sin(spin), p.y, across * cos(spin) - out_along * sin(spin));
}

Box kaleidoscope_bounds(float radius, Box child)
{
    float own = length(vec2(abs(child.centre.x) + child.half_size.x, abs(child.centre.z) + child.half_size.z));
    float reach = (radius + own) * 1.000001f;
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(reach, child.half_size.y, reach));
}
