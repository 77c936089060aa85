// Square root: The number whose square this is; 0 for negative numbers.
// synonyms: sqrt, root, math
float square_root_value(
    float x)  // 1.0 [-1000000, 1000000] [-10, 10]  The number.
{
    return sqrt(max(x, 0.0f));
}
