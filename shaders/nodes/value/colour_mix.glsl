// Colour mix: A colour between two colours.
// synonyms: blend, gradient, lerp, color
vec3 colour_mix_value(
    vec3 first,    // #1f4e79  Colour at amount 0.
    vec3 second,   // #e8a33d  Colour at amount 1.
    float amount)  // 0.5 [0, 1]  How far on the way from the first to the second.
{
    return mix(first, second, amount);
}
