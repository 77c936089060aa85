// Mix: A number between two numbers.
// synonyms: lerp, blend, interpolate
float mix_value(
    float first,   // 0.0 [-1000000, 1000000] [-10, 10]  Number at amount 0.
    float second,  // 1.0 [-1000000, 1000000] [-10, 10]  Number at amount 1.
    float amount)  // 0.5 [-1000, 1000] [0, 1]  How far on the way from the first to the second.
{
    return mix(first, second, amount);
}
