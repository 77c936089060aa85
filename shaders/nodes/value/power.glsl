// Power: A number raised to an exponent; negative numbers count as 0.
// synonyms: exponent, square, cube, root, pow, gamma
float power_value(
    float x,         // 1.0 [-1000000, 1000000] [-10, 10]  The number.
    float exponent)  // 2.0 [-20, 20] [-4, 4]  The exponent; 0.5 is the square root.
{
    return x > 0.0f ? min(pow(x, exponent), 1.0e12f) : 0.0f;
}
