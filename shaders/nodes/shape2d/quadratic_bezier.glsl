// Quadratic Bezier: A curved stroke that one handle bends, with round ends.
// field: exact; bound
// synonyms: curve, quadratic curve, spline, arc, swoosh

// The root of a cubic that crosses zero at most once between `low` and `high`, or the end nearest to it.
float quadratic_bezier_root(vec4 cubic, float from, float to)
{
    float low = from;
    float high = to;
    float falling = ((cubic.x * low + cubic.y) * low + cubic.z) * low + cubic.w > 0.0f ? -1.0f : 1.0f;
    float t = 0.5f * (low + high);
    for (int i = 0; i < 12; i++) {
        float value = falling * (((cubic.x * t + cubic.y) * t + cubic.z) * t + cubic.w);
        float slope = falling * ((3.0f * cubic.x * t + 2.0f * cubic.y) * t + cubic.z);
        low = value < 0.0f ? t : low;
        high = value < 0.0f ? high : t;
        // Newton's step where it stays between the ends, else half the way.
        float next = t - value / (abs(slope) > 1.0e-12f ? slope : 1.0e-12f);
        t = next >= low && next <= high ? next : 0.5f * (low + high);
    }
    return t;
}

float quadratic_bezier_squared(vec2 from_start, vec2 linear, vec2 bend, float t)
{
    vec2 away = from_start - (2.0f * linear + bend * t) * t;
    return dot(away, away);
}

float quadratic_bezier_distance(
    vec2 p,
    vec2 start,       // (-0.6, -0.3) [-100, 100] [-2, 2] m  Where the stroke begins.
    vec2 handle,      // (0.0, 0.9) [-100, 100] [-2, 2] m  Point that pulls the middle of the stroke.
    vec2 finish,      // (0.6, -0.3) [-100, 100] [-2, 2] m  Where the stroke ends.
    float thickness)  // 0.18 [0.001, 100] [0.01, 2] m  Width of the stroke.
{
    vec2 linear = handle - start;
    vec2 bend = finish - 2.0f * handle + start;
    vec2 q = p - start;
    // Half the derivative of the squared distance along the curve: its roots are the nearest points.
    vec4 cubic = vec4(dot(bend, bend), 3.0f * dot(linear, bend), 2.0f * dot(linear, linear) - dot(q, bend),
                      -dot(q, linear));
    // Between its turning points it crosses zero at most once.
    float middle = -cubic.y / max(3.0f * cubic.x, 1.0e-12f);
    float spread = cubic.y * cubic.y - 3.0f * cubic.x * cubic.z;
    float reach = sqrt(max(spread, 0.0f)) / max(3.0f * cubic.x, 1.0e-12f);
    float first = clamp(middle - reach, 0.0f, 1.0f);
    float second = clamp(middle + reach, 0.0f, 1.0f);
    float in_front = quadratic_bezier_root(cubic, 0.0f, first);
    float between = quadratic_bezier_root(cubic, first, second);
    float behind = quadratic_bezier_root(cubic, second, 1.0f);
    float squared = min(dot(q, q), dot(p - finish, p - finish));
    squared = min(squared, quadratic_bezier_squared(q, linear, bend, in_front));
    squared = min(squared, quadratic_bezier_squared(q, linear, bend, between));
    squared = min(squared, quadratic_bezier_squared(q, linear, bend, behind));
    return sqrt(squared) - 0.5f * thickness;
}

Box quadratic_bezier_bounds(vec2 start, vec2 handle, vec2 finish, float thickness)
{
    vec2 low = min(min(start, handle), finish);
    vec2 high = max(max(start, handle), finish);
    vec2 centre = 0.5f * (low + high);
    vec2 reach = 0.5f * (high - low) + vec2(0.5f * thickness);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
