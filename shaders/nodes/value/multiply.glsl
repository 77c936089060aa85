// Multiply: The product of two numbers.
// synonyms: times, product, scale, math
float multiply_value(
    float first,   // 1.0 [-1000000, 1000000] [-10, 10]  First number.
    float second)  // 1.0 [-1000000, 1000000] [-10, 10]  Second number.
{
    return first * second;
}
