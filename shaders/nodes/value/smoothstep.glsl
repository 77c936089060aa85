// Smoothstep: A soft passage from 0 to 1 between two edges.
// synonyms: ease, soft threshold, fade, s-curve, hermite
float smoothstep_value(
    float x,      // 0.5 [-1000000, 1000000] [-10, 10]  The number.
    float start,  // 0.0 [-1000000, 1000000] [-10, 10]  Where the passage begins.
    float end)    // 1.0 [-1000000, 1000000] [-10, 10]  Where it ends; may lie below the start.
{
    float span = end - start;
    float share = abs(span) < 1.0e-9f ? (x < start ? 0.0f : 1.0f) : clamp((x - start) / span, 0.0f, 1.0f);
    return share * share * (3.0f - 2.0f * share);
}
