// Custom value: waves from 0 to 1 over space, yours to change.
float custom_number_value(
    vec3 p,
    float frequency,  // 6.0 [0, 100] [1, 30] 1/m  How close the waves are.
    float contrast)   // 1.0 [0, 1]  How far the waves go from the middle.
{
    return 0.5f + 0.5f * contrast * sin(frequency * p.x) * sin(frequency * p.z);
}
