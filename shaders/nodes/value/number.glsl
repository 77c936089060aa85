// Number: One number, to share between nodes.
// synonyms: constant, float, slider, scalar
float number_value(
    float value)  // 1.0 [-1000000, 1000000] [-10, 10]  The number.
{
    return value;
}
