// Parabola: A bowl between a parabola and a straight rim.
// field: exact
// synonyms: bowl, dish, parabolic segment, cup
float parabola_distance(
    vec2 p,
    float half_width,  // 0.5 [0.001, 100] [0.05, 5] m  Half the width of the rim.
    float height)      // 0.8 [0.001, 200] [0.05, 5] m  Depth from the rim to the lowest point.
{
    vec2 q = vec2(abs(p.x), p.y + 0.5f * height) / half_width;
    float rise = height / half_width;
    // The point (t, rise t^2) nearest to q; the derivative of the distance crosses zero once for t > 0.
    float linear = 1.0f - 2.0f * rise * q.y;
    float cube = 2.0f * rise * rise;
    float low = 0.0f;
    float high = 1.0f;
    float t = 1.0f;
    for (int i = 0; i < 14; i++) {
        float value = (cube * t * t + linear) * t - q.x;
        float slope = 3.0f * cube * t * t + linear;
        low = value < 0.0f ? t : low;
        high = value < 0.0f ? high : t;
        float next = t - value / (abs(slope) > 1.0e-12f ? slope : 1.0e-12f);
        t = next >= low && next <= high ? next : 0.5f * (low + high);
    }
    vec2 from_bowl = vec2(q.x - t, q.y - rise * t * t);
    vec2 from_rim = vec2(max(q.x - 1.0f, 0.0f), q.y - rise);
    float outline = half_width * sqrt(min(dot(from_bowl, from_bowl), dot(from_rim, from_rim)));
    return q.y > rise * q.x * q.x && q.y < rise ? -outline : outline;
}

Box parabola_bounds(float half_width, float height)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_width, 0.5f * height, 0.0f));
}
