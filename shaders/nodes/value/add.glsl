// Add: The sum of two numbers.
// synonyms: plus, sum, math
float add_value(
    float first,   // 0.0 [-1000000, 1000000] [-10, 10]  First number.
    float second)  // 0.0 [-1000000, 1000000] [-10, 10]  Second number.
{
    return first + second;
}
