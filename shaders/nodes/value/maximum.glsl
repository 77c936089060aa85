// Maximum: The larger of two numbers.
// synonyms: max, greatest, upper, math
float maximum_value(
    float first,   // 0.0 [-1000000, 1000000] [-10, 10]  First number.
    float second)  // 0.0 [-1000000, 1000000] [-10, 10]  Second number.
{
    return max(first, second);
}
