// Vector mix: A vector between two vectors.
// synonyms: lerp, blend, interpolate, vector
vec3 vector_mix_value(
    vec3 first,    // (0, 0, 0) [-1000000, 1000000] [-10, 10]  Vector at amount 0.
    vec3 second,   // (1, 1, 1) [-1000000, 1000000] [-10, 10]  Vector at amount 1.
    float amount)  // 0.5 [-1000, 1000] [0, 1]  How far on the way from the first to the second.
{
    return mix(first, second, amount);
}
