// Multiply-add: A number times a factor plus another number.
// synonyms: scale and offset, linear, map range, fma
float multiply_add_value(
    float x,       // 0.0 [-1000000, 1000000] [-10, 10]  The number.
    float factor,  // 1.0 [-1000000, 1000000] [-10, 10]  What it is multiplied by.
    float addend)  // 0.0 [-1000000, 1000000] [-10, 10]  What is added then.
{
    return x * factor + addend;
}
