// Waves: A level band that rises and falls in waves.
// field: bound
// synonyms: sine, wavy line, ripple, water, squiggle
const float WAVES_TWO_PI = 6.28318531f;

float waves_distance(
    vec2 p,
    float amplitude,   // 0.15 [0, 10] [0, 1] m  Height of the crests above the middle.
    float wavelength,  // 0.6 [0.01, 100] [0.1, 5] m  Distance from crest to crest.
    float thickness,   // 0.2 [0.001, 100] [0.01, 2] m  Height of the band.
    float span)        // 1.8 [0.001, 200] [0.1, 10] m  Length of the band.
{
    float band = abs(p.y - amplitude * sin(p.x * (WAVES_TWO_PI / wavelength))) - 0.5f * thickness;
    return max(band, abs(p.x) - 0.5f * span);
}

float waves_lipschitz(float amplitude, float wavelength)
{
    return length(vec2(1.0f, amplitude * WAVES_TWO_PI / wavelength));
}

Box waves_bounds(float amplitude, float thickness, float span)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(0.5f * span, amplitude + 0.5f * thickness, 0.0f));
}
