// Remap: Carries a number from one range over to another.
// synonyms: map range, fit, scale, linear, normalise, convert
float remap_value(
    float x,          // 0.5 [-1000000, 1000000] [-10, 10]  The number.
    float from_low,   // 0.0 [-1000000, 1000000] [-10, 10]  Start of the range it comes from.
    float from_high,  // 1.0 [-1000000, 1000000] [-10, 10]  End of the range it comes from.
    float to_low,     // 0.0 [-1000000, 1000000] [-10, 10]  Result at the start.
    float to_high,    // 1.0 [-1000000, 1000000] [-10, 10]  Result at the end.
    bool limited)     // true  Keep the result between the two.
{
    float span = from_high - from_low;
    float share = abs(span) < 1.0e-9f ? 0.0f : (x - from_low) / span;
    return mix(to_low, to_high, limited ? clamp(share, 0.0f, 1.0f) : share);
}
