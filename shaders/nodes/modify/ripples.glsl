// Ripples: Covers a solid with circular waves around the y axis, like those around a stone thrown into water.
// field: bound
// synonyms: rings, water, drop, waves, concentric, pond
const float RIPPLES_TWO_PI = 6.28318531f;

float ripples_distance(
    vec3 p,
    float d,
    float amplitude,   // 0.03 [0, 10] [0, 0.5] m  Height of the crests and depth of the troughs.
    float wavelength,  // 0.2 [0.01, 100] [0.05, 5] m  Distance from crest to crest.
    float phase)       // 0.0 [-36000, 36000] [-180, 180] deg  Where the waves begin; wire time to let them spread.
{
    float turns = length(vec2(p.x, p.z)) / wavelength;
    return d - amplitude * cos((turns - floor(turns)) * RIPPLES_TWO_PI - phase);
}

float ripples_lipschitz(float amplitude, float wavelength)
{
    return 1.0f + amplitude * RIPPLES_TWO_PI / wavelength;
}

Box ripples_bounds(float amplitude, Box child)
{
    return grow_box(child, amplitude);
}
