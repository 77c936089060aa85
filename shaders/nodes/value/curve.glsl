// Curve: A number read off a curve through points that you drag. At most 32 points count; outside it stays level.
// synonyms: graph, profile, ease, spline, tone curve, lookup, remap, falloff, interpolate

// The slope at a point between two chords that makes no hill or valley of its own (Steffen 1990).
float curve_slope(float chord_before, float width_before, float chord, float width)
{
    float parabola = (chord_before * width + chord * width_before) / (width_before + width);
    float least = min(min(abs(chord_before), abs(chord)), 0.5f * abs(parabola));
    return (sign(chord_before) + sign(chord)) * least;
}

float curve_value(
    float x,      // 0.5 [-1000000, 1000000] [0, 1]  Where on the curve.
    List points,  // [(0, 0), (0.35, 0.75), (0.65, 0.55), (1, 1)] [-10000, 10000]  Points of the curve: where, then the result.
    int style)    // smooth {smooth, linear}  How it runs from point to point: smoothly without overshoot, or straight.
{
    float far_away = 1.0e9f;
    vec2 left = vec2(-far_away, 0.0f);
    vec2 right = vec2(far_away, 0.0f);
    for (int i = 0; i < 32; i++) {
        if (i >= points.count) {
            break;
        }
        vec4 point = list_at(points, i);
        bool is_left = point.x <= x && point.x >= left.x;
        bool is_right = point.x > x && point.x < right.x;
        left = is_left ? vec2(point.x, point.y) : left;
        right = is_right ? vec2(point.x, point.y) : right;
    }
    vec2 before = vec2(-far_away, 0.0f);
    vec2 after = vec2(far_away, 0.0f);
    for (int i = 0; i < 32; i++) {
        if (i >= points.count) {
            break;
        }
        vec4 point = list_at(points, i);
        bool is_before = point.x < left.x && point.x >= before.x;
        bool is_after = point.x > right.x && point.x < after.x;
        before = is_before ? vec2(point.x, point.y) : before;
        after = is_after ? vec2(point.x, point.y) : after;
    }
    float width = max(right.x - left.x, 1.0e-9f);
    float chord = (right.y - left.y) / width;
    float width_before = max(left.x - before.x, 1.0e-9f);
    float width_after = max(after.x - right.x, 1.0e-9f);
    float slope_left = curve_slope((left.y - before.y) / width_before, width_before, chord, width);
    float slope_right = curve_slope(chord, width, (after.y - right.y) / width_after, width_after);
    slope_left = before.x > -far_away ? slope_left : chord;
    slope_right = after.x < far_away ? slope_right : chord;
    float t = clamp((x - left.x) / width, 0.0f, 1.0f);
    float bend = (slope_left - chord) * (1.0f - t) - (slope_right - chord) * t;
    float inner = left.y + t * (right.y - left.y) + (style == 0 ? t * (1.0f - t) * width * bend : 0.0f);
    return left.x <= -far_away ? (right.x < far_away ? right.y : 0.0f) : (right.x >= far_away ? left.y : inner);
}
