// Value noise: Random numbers that change smoothly from place to place.
// synonyms: random, smooth, clouds, blobs, texture

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float value_noise_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float value_noise_shuffle(float x)
{
    return value_noise_remainder(value_noise_remainder(34.0f * x + 1.0f) * x);
}

float value_noise_corner(float hash, float y, float z)
{
    float mixed = value_noise_shuffle(hash + value_noise_remainder(y));
    return value_noise_shuffle(mixed + value_noise_remainder(z)) / 144.0f - 1.0f;
}

float value_noise_edge(vec2 hashes, float y, float z, float w)
{
    return mix(value_noise_corner(hashes.x, y, z), value_noise_corner(hashes.y, y, z), w);
}

// Random numbers from -1 to 1 at whole-numbered places, and smoothly between. No slope exceeds 2 sqrt(3).
float value_noise_noise(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * (vec3(3.0f) - 2.0f * f);
    float low = value_noise_shuffle(value_noise_remainder(base.x) + seed);
    float high = value_noise_shuffle(value_noise_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    float near_low = value_noise_edge(hashes, base.y, base.z, w.x);
    float near_high = value_noise_edge(hashes, base.y + 1.0f, base.z, w.x);
    float far_low = value_noise_edge(hashes, base.y, base.z + 1.0f, w.x);
    float far_high = value_noise_edge(hashes, base.y + 1.0f, base.z + 1.0f, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

float value_noise_value(
    vec3 p,
    vec3 shift,     // (0, 0, 0) [-1000000, 1000000] [-5, 5] m  Moves the pattern; wire time here to let it flow.
    float size,     // 0.5 [0.001, 1000] [0.05, 5] m  Size of the pattern.
    int seed,       // 0 [0, 1000]  Another seed gives another pattern.
    float minimum,  // 0.0 [-1000000, 1000000] [-10, 10]  Result at the smallest.
    float maximum)  // 1.0 [-1000000, 1000000] [-10, 10]  Result at the largest.
{
    vec3 q = (p - shift) / size;
    float start = value_noise_remainder(float(seed));
    return mix(minimum, maximum, 0.5f + 0.5f * value_noise_noise(q, start));
}
