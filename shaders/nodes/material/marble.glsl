// Marble: Veins that wind through a stone.
// synonyms: stone, veins, swirl, turbulence, pattern

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float marble_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float marble_shuffle(float x)
{
    return marble_remainder(marble_remainder(34.0f * x + 1.0f) * x);
}

float marble_corner(float hash, float y, float z)
{
    float mixed = marble_shuffle(hash + marble_remainder(y));
    return marble_shuffle(mixed + marble_remainder(z)) / 144.0f - 1.0f;
}

float marble_edge(vec2 hashes, float y, float z, float w)
{
    return mix(marble_corner(hashes.x, y, z), marble_corner(hashes.y, y, z), w);
}

// Random numbers from -1 to 1 at whole-numbered places, and smoothly between. No slope exceeds 2 sqrt(3).
float marble_noise(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * (vec3(3.0f) - 2.0f * f);
    float low = marble_shuffle(marble_remainder(base.x) + seed);
    float high = marble_shuffle(marble_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    float near_low = marble_edge(hashes, base.y, base.z, w.x);
    float near_high = marble_edge(hashes, base.y + 1.0f, base.z, w.x);
    float far_low = marble_edge(hashes, base.y, base.z + 1.0f, w.x);
    float far_high = marble_edge(hashes, base.y + 1.0f, base.z + 1.0f, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

Material marble_material(
    vec3 p,
    vec3 first,        // #e9e6e0  Colour of the stone.
    vec3 second,       // #5a6068  Colour of the veins.
    vec3 across,       // (1, 1, 0.5) [-1000, 1000] [-1, 1]  Direction across the veins; its length does not matter.
    float size,        // 0.5 [0.001, 1000] [0.05, 5] m  Distance from vein to vein.
    float turbulence,  // 1.0 [0, 100] [0, 5]  How far the veins wind, in distances between them.
    float sharpness,   // 5.0 [1, 100] [1, 20]  From broad clouds to thin veins.
    int seed,          // 0 [0, 1000]  Another seed gives another stone.
    float specular,    // 0.04 [0, 1]  Strength of the highlight.
    float shininess)   // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    float strength = length(across);
    vec3 unit = strength > 1.0e-6f ? across / max(strength, 1.0e-6f) : vec3(1.0f, 0.0f, 0.0f);
    float start = marble_remainder(float(seed));
    vec3 q = p / size;
    float wind = marble_noise(q, start) + 0.5f * marble_noise(2.0f * q + vec3(0.37f), marble_remainder(start + 97.0f));
    wind += 0.25f * marble_noise(4.0f * q + vec3(0.71f), marble_remainder(start + 181.0f));
    float turns = dot(q, unit) + 0.5f * turbulence * wind;
    float from_vein = 2.0f * abs(turns - floor(turns + 0.5f));
    float share = pow(max(1.0f - from_vein, 1.0e-6f), sharpness);
    return make_material(mix(first, second, share), vec3(specular), shininess, vec3(0.0f));
}
