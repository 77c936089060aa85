// Colour ramp: A colour from a row of three, as a number tells; the borders may be soft or hard.
// synonyms: gradient, stops, map, lookup, color, bands, palette
float colour_ramp_passage(float x, float from, float to, float hardness)
{
    float middle = 0.5f * (from + to);
    float span = max((to - from) * (1.0f - hardness), 1.0e-6f);
    return clamp((x - middle) / span + 0.5f, 0.0f, 1.0f);
}

vec3 colour_ramp_value(
    float x,         // 0.5 [-1000000, 1000000] [-10, 10]  The number.
    vec3 first,      // #14213d  Colour before the first stop.
    vec3 second,     // #e8a33d  Colour at the second stop.
    vec3 third,      // #f4f1de  Colour from the third stop on.
    float stop_1,    // 0.0 [-1000000, 1000000] [0, 1]  Where the first stop is.
    float stop_2,    // 0.5 [-1000000, 1000000] [0, 1]  Where the second stop is.
    float stop_3,    // 1.0 [-1000000, 1000000] [0, 1]  Where the third stop is.
    float hardness)  // 0.0 [0, 1]  From a gradient to hard borders halfway between the stops.
{
    vec3 below = mix(first, second, colour_ramp_passage(x, stop_1, max(stop_2, stop_1), hardness));
    return mix(below, third, colour_ramp_passage(x, stop_2, max(stop_3, stop_2), hardness));
}
