// Angle: The angle of a point seen from the origin, counter-clockwise from the first axis.
// synonyms: arc tangent, atan2, polar, bearing, direction, trigonometry
const float ANGLE_PI = 3.14159265f;

float angle_value(
    float x,  // 1.0 [-1000000, 1000000] [-10, 10]  How far along the first axis.
    float y)  // 0.0 [-1000000, 1000000] [-10, 10]  How far along the second axis.
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * ANGLE_PI - angle : angle;
    angle = x < 0.0f ? ANGLE_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}
