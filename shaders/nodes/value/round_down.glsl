// Round down: The largest whole number that is not larger.
// synonyms: floor, integer, truncate, whole, quantise, math
float round_down_value(
    float x)  // 0.0 [-1000000, 1000000] [-10, 10]  The number.
{
    return floor(x);
}
