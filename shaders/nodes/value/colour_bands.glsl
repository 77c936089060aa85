// Colour bands: One of four colours, as a number tells, with borders where you set them, hard or soft.
// synonyms: hard stops, colour ramp, gradient, threshold, toon, palette, eye, rings, color
float colour_bands_beyond(float x, float border, float softness)
{
    float share = clamp((x - border) / max(softness, 1.0e-6f) + 0.5f, 0.0f, 1.0f);
    return softness > 1.0e-6f ? share : (x > border ? 1.0f : 0.0f);
}

vec3 colour_bands_value(
    float x,         // 0.5 [-1000000, 1000000] [-10, 10]  The number.
    vec3 first,      // #9fb3c8  Colour up to the first border.
    vec3 second,     // #101014  Colour up to the second border.
    vec3 third,      // #f4f1e6  Colour up to the third border.
    vec3 fourth,     // #101014  Colour beyond the third border.
    float border_1,  // 0.89 [-1000000, 1000000] [0, 1]  Where the first colour ends.
    float border_2,  // 0.9 [-1000000, 1000000] [0, 1]  Where the second colour ends.
    float border_3,  // 0.995 [-1000000, 1000000] [0, 1]  Where the third colour ends.
    float softness)  // 0.0 [0, 1000000] [0, 0.2]  How wide each border is: 0 is hard.
{
    vec3 colour = mix(first, second, colour_bands_beyond(x, border_1, softness));
    colour = mix(colour, third, colour_bands_beyond(x, border_2, softness));
    return mix(colour, fourth, colour_bands_beyond(x, border_3, softness));
}
