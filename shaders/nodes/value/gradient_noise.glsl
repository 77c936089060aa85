// Gradient noise: Perlin's noise, random swells without a grid to be seen.
// synonyms: perlin, random, smooth, clouds, waves, texture

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float gradient_noise_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float gradient_noise_shuffle(float x)
{
    return gradient_noise_remainder(gradient_noise_remainder(34.0f * x + 1.0f) * x);
}

// The slope of a corner, a random one of the twelve directions to the edges of a cube, times the way from there.
float gradient_noise_corner(float hash, vec3 cell, vec3 f)
{
    float mixed = gradient_noise_shuffle(hash + gradient_noise_remainder(cell.y));
    mixed = gradient_noise_shuffle(mixed + gradient_noise_remainder(cell.z));
    float pick = mixed - 12.0f * floor((mixed + 0.5f) / 12.0f);
    float kind = floor((pick + 0.5f) / 4.0f);
    float signs = pick - 4.0f * kind;
    float first = signs < 1.5f ? 1.0f : -1.0f;
    float second = signs - 2.0f * floor((signs + 0.5f) / 2.0f) < 0.5f ? 1.0f : -1.0f;
    float u = kind < 1.5f ? f.x : f.y;
    float v = kind < 0.5f ? f.y : f.z;
    return first * u + second * v;
}

float gradient_noise_edge(vec2 hashes, vec3 cell, vec3 f, float w)
{
    vec3 next = f - vec3(1.0f, 0.0f, 0.0f);
    return mix(gradient_noise_corner(hashes.x, cell, f), gradient_noise_corner(hashes.y, cell, next), w);
}

// Ken Perlin's gradient noise (2002), from about -1 to 1.
float gradient_noise_noise(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * f * (f * (f * 6.0f - vec3(15.0f)) + vec3(10.0f));
    float low = gradient_noise_shuffle(gradient_noise_remainder(base.x) + seed);
    float high = gradient_noise_shuffle(gradient_noise_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    vec3 y = vec3(0.0f, 1.0f, 0.0f);
    vec3 z = vec3(0.0f, 0.0f, 1.0f);
    float near_low = gradient_noise_edge(hashes, base, f, w.x);
    float near_high = gradient_noise_edge(hashes, base + y, f - y, w.x);
    float far_low = gradient_noise_edge(hashes, base + z, f - z, w.x);
    float far_high = gradient_noise_edge(hashes, base + y + z, f - y - z, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

float gradient_noise_value(
    vec3 p,
    vec3 shift,     // (0, 0, 0) [-1000000, 1000000] [-5, 5] m  Moves the pattern; wire time here to let it flow.
    float size,     // 0.5 [0.001, 1000] [0.05, 5] m  Size of the pattern.
    int seed,       // 0 [0, 1000]  Another seed gives another pattern.
    float minimum,  // 0.0 [-1000000, 1000000] [-10, 10]  Result at the smallest.
    float maximum)  // 1.0 [-1000000, 1000000] [-10, 10]  Result at the largest.
{
    vec3 q = (p - shift) / size;
    float start = gradient_noise_remainder(float(seed));
    return mix(minimum, maximum, clamp(0.5f + 0.5f * gradient_noise_noise(q, start), 0.0f, 1.0f));
}
