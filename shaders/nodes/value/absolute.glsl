// Absolute: A number without its sign.
// synonyms: abs, magnitude, positive, math
float absolute_value(
    float x)  // 0.0 [-1000000, 1000000] [-10, 10]  The number.
{
    return abs(x);
}
