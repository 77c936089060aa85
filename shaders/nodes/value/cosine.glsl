// Cosine: The cosine of an angle.
// synonyms: cos, trigonometry, circle, wave, math
float cosine_value(
    float angle)  // 0.0 [-36000, 36000] [-180, 180] deg  The angle.
{
    return cos(angle);
}
