// Minus: One number minus another.
// synonyms: take away, subtract numbers, difference, math
float minus_value(
    float first,   // 0.0 [-1000000, 1000000] [-10, 10]  Number that is taken from.
    float second)  // 0.0 [-1000000, 1000000] [-10, 10]  Number that is taken away.
{
    return first - second;
}
