// Displace: Covers the surface of a solid with regular bumps.
// field: bound
// synonyms: bumps, ripple, waves, emboss, noise
const float DISPLACE_TWO_PI = 6.28318531f;

float displace_distance(
    vec3 p,
    float d,
    float amplitude,   // 0.05 [0, 10] [0, 0.5] m  Height of the bumps and depth of the dents.
    float wavelength)  // 0.5 [0.01, 100] [0.05, 5] m  Distance from bump to bump along each axis.
{
    vec3 q = p * (DISPLACE_TWO_PI / wavelength);
    return d + amplitude * sin(q.x) * sin(q.y) * sin(q.z);
}

float displace_lipschitz(float amplitude, float wavelength)
{
    return 1.0f + amplitude * DISPLACE_TWO_PI / wavelength;
}

Box displace_bounds(float amplitude, Box child)
{
    return grow_box(child, amplitude);
}
