// Noise warp: Moves every part of a solid by a random amount that changes smoothly from place to place.
// field: bound
// synonyms: distort, turbulence, wobble, crumple, melt, domain warping

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float noise_warp_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float noise_warp_shuffle(float x)
{
    return noise_warp_remainder(noise_warp_remainder(34.0f * x + 1.0f) * x);
}

// A random vector, no longer than 1.
vec3 noise_warp_corner(float hash, float y, float z)
{
    float first = noise_warp_shuffle(noise_warp_shuffle(hash + noise_warp_remainder(y)) + noise_warp_remainder(z));
    float second = noise_warp_shuffle(first + 71.0f);
    float third = noise_warp_shuffle(second + 157.0f);
    return (vec3(first, second, third) / 144.0f - vec3(1.0f)) * 0.57735026f;
}

vec3 noise_warp_edge(vec2 hashes, float y, float z, float w)
{
    return mix(noise_warp_corner(hashes.x, y, z), noise_warp_corner(hashes.y, y, z), w);
}

vec3 noise_warp_shift(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * (vec3(3.0f) - 2.0f * f);
    float low = noise_warp_shuffle(noise_warp_remainder(base.x) + seed);
    float high = noise_warp_shuffle(noise_warp_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    vec3 near_low = noise_warp_edge(hashes, base.y, base.z, w.x);
    vec3 near_high = noise_warp_edge(hashes, base.y + 1.0f, base.z, w.x);
    vec3 far_low = noise_warp_edge(hashes, base.y, base.z + 1.0f, w.x);
    vec3 far_high = noise_warp_edge(hashes, base.y + 1.0f, base.z + 1.0f, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

vec3 noise_warp_point(
    vec3 p,
    float amplitude,  // 0.25 [0, 100] [0, 1] m  Farthest that a part moves.
    float size,       // 0.6 [0.01, 1000] [0.1, 5] m  Distance over which the movement changes.
    int seed)         // 0 [0, 1000]  Another seed moves differently.
{
    return p - amplitude * noise_warp_shift(p / size, noise_warp_remainder(float(seed)));
}

// No interpolation of vectors within the unit ball by 3 t^2 - 2 t^3 is steeper than 2 sqrt(3).
float noise_warp_stretch(float amplitude, float size)
{
    return 1.0f + 3.4642f * amplitude / size;
}

Box noise_warp_bounds(float amplitude, Box child)
{
    return grow_box(child, amplitude);
}
