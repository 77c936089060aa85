// Compare: 1 where a comparison of two numbers holds, else 0.
// synonyms: greater, less, equal, condition, test, logic
float compare_value(
    float first,      // 0.0 [-1000000, 1000000] [-10, 10]  First number.
    int comparison,   // less {less, greater, equal}  How the first must be, compared with the second.
    float second,     // 0.5 [-1000000, 1000000] [-10, 10]  Second number.
    float tolerance)  // 0.001 [0, 1000000] [0, 1]  How far apart equal numbers may be.
{
    bool equal = abs(first - second) <= tolerance;
    bool holds = comparison == 0 ? first < second : (comparison == 1 ? first > second : equal);
    return holds ? 1.0f : 0.0f;
}
