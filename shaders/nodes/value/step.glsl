// Step: 0 below an edge, 1 from the edge on.
// synonyms: threshold, cut, hard edge, binary
float step_value(
    float x,     // 0.0 [-1000000, 1000000] [-10, 10]  The number.
    float edge)  // 0.5 [-1000000, 1000000] [-10, 10]  Where the result changes.
{
    return x < edge ? 0.0f : 1.0f;
}
