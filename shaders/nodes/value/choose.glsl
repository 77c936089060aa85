// Switch: One of two numbers, as a third one tells.
// synonyms: if, select, either, condition, ternary, logic
float choose_value(
    float choice,  // 0.0 [-1000000, 1000000] [-10, 10]  Below a half the first number is taken, else the second.
    float first,   // 0.0 [-1000000, 1000000] [-10, 10]  Number that is taken below a half.
    float second)  // 1.0 [-1000000, 1000000] [-10, 10]  Number that is taken else.
{
    return choice < 0.5f ? first : second;
}
