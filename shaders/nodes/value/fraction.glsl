// Fraction: What a number has after its whole part.
// synonyms: fract, decimals, wrap, saw, math
float fraction_value(
    float x)  // 0.0 [-1000000, 1000000] [-10, 10]  The number.
{
    return x - floor(x);
}
