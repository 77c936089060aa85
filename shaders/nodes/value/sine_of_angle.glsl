// Sine of angle: The sine of an angle.
// synonyms: trigonometry, circle, wave, math
float sine_of_angle_value(
    float angle)  // 0.0 [-36000, 36000] [-180, 180] deg  The angle.
{
    return sin(angle);
}
