// Displace by noise: Covers the surface of a solid with irregular bumps and dents.
// field: bound
// synonyms: rough, rock, bumps, turbulence, fbm, terrain, erosion

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float displace_noise_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float displace_noise_shuffle(float x)
{
    return displace_noise_remainder(displace_noise_remainder(34.0f * x + 1.0f) * x);
}

float displace_noise_corner(float hash, float y, float z)
{
    float mixed = displace_noise_shuffle(hash + displace_noise_remainder(y));
    return displace_noise_shuffle(mixed + displace_noise_remainder(z)) / 144.0f - 1.0f;
}

float displace_noise_edge(vec2 hashes, float y, float z, float w)
{
    return mix(displace_noise_corner(hashes.x, y, z), displace_noise_corner(hashes.y, y, z), w);
}

// Random numbers from -1 to 1 at whole-numbered places, and smoothly between. No slope exceeds 2 sqrt(3).
float displace_noise_noise(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * (vec3(3.0f) - 2.0f * f);
    float low = displace_noise_shuffle(displace_noise_remainder(base.x) + seed);
    float high = displace_noise_shuffle(displace_noise_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    float near_low = displace_noise_edge(hashes, base.y, base.z, w.x);
    float near_high = displace_noise_edge(hashes, base.y + 1.0f, base.z, w.x);
    float far_low = displace_noise_edge(hashes, base.y, base.z + 1.0f, w.x);
    float far_high = displace_noise_edge(hashes, base.y + 1.0f, base.z + 1.0f, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

float displace_noise_distance(
    vec3 p,
    float d,
    float amplitude,  // 0.12 [0, 100] [0, 1] m  Height of the highest bumps and depth of the deepest dents.
    float size,       // 0.4 [0.01, 1000] [0.05, 5] m  Distance over which the height changes.
    float detail,     // 0.5 [0, 1]  Strength of bumps of half the size.
    int seed)         // 0 [0, 1000]  Another seed gives other bumps.
{
    float start = displace_noise_remainder(float(seed));
    float coarse = displace_noise_noise(p / size, start);
    float fine = displace_noise_noise(p * (2.0f / size) + vec3(0.37f), displace_noise_remainder(start + 97.0f));
    return d - amplitude * (coarse + 0.5f * detail * fine) / (1.0f + 0.5f * detail);
}

// Bumps of half the size and half the height are as steep as the others.
float displace_noise_lipschitz(float amplitude, float size, float detail)
{
    return 1.0f + 3.4642f * amplitude / size * (1.0f + detail) / (1.0f + 0.5f * detail);
}

Box displace_noise_bounds(float amplitude, Box child)
{
    return grow_box(child, amplitude);
}
