// Displace by waves: Covers the surface of a solid with straight, parallel ridges.
// field: bound
// synonyms: ridges, corrugate, grooves, ribs, sine, furrows
const float DISPLACE_WAVES_TWO_PI = 6.28318531f;

float displace_waves_distance(
    vec3 p,
    float d,
    vec3 ridges,       // (0, 1, 0) [-1000, 1000] [-1, 1]  Direction across the ridges; its length does not matter.
    float amplitude,   // 0.04 [0, 10] [0, 0.5] m  Height of the ridges and depth of the furrows.
    float wavelength,  // 0.25 [0.01, 100] [0.05, 5] m  Distance from ridge to ridge.
    float phase)       // 0.0 [-36000, 36000] [-180, 180] deg  Where the waves begin; wire time to let them run.
{
    float size = length(ridges);
    vec3 across = size > 1.0e-6f ? ridges / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    float turns = dot(p, across) / wavelength;
    return d - amplitude * sin((turns - floor(turns)) * DISPLACE_WAVES_TWO_PI - phase);
}

float displace_waves_lipschitz(float amplitude, float wavelength)
{
    return 1.0f + amplitude * DISPLACE_WAVES_TWO_PI / wavelength;
}

Box displace_waves_bounds(float amplitude, Box child)
{
    return grow_box(child, amplitude);
}
