// Minimum: The smaller of two numbers.
// synonyms: min, least, lower, math
float minimum_value(
    float first,   // 0.0 [-1000000, 1000000] [-10, 10]  First number.
    float second)  // 0.0 [-1000000, 1000000] [-10, 10]  Second number.
{
    return min(first, second);
}
