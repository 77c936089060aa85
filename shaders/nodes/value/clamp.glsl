// Clamp: A number kept between two others.
// synonyms: limit, saturate, restrict, range, math
float clamp_value(
    float x,        // 0.0 [-1000000, 1000000] [-10, 10]  The number.
    float minimum,  // 0.0 [-1000000, 1000000] [-10, 10]  Smallest result.
    float maximum)  // 1.0 [-1000000, 1000000] [-10, 10]  Largest result.
{
    return min(max(x, minimum), maximum);
}
