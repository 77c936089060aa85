// Divide: One number divided by another; 0 where that is 0.
// synonyms: quotient, ratio, over, math
float divide_value(
    float first,   // 1.0 [-1000000, 1000000] [-10, 10]  Number that is divided.
    float second)  // 2.0 [-1000000, 1000000] [-10, 10]  Number that it is divided by.
{
    return second == 0.0f ? 0.0f : first / (second == 0.0f ? 1.0f : second);
}
