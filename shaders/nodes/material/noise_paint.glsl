// Noise paint: Two colours in random clouds.
// synonyms: clouds, spots, camouflage, dirt, mottled, pattern

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float noise_paint_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float noise_paint_shuffle(float x)
{
    return noise_paint_remainder(noise_paint_remainder(34.0f * x + 1.0f) * x);
}

float noise_paint_corner(float hash, float y, float z)
{
    float mixed = noise_paint_shuffle(hash + noise_paint_remainder(y));
    return noise_paint_shuffle(mixed + noise_paint_remainder(z)) / 144.0f - 1.0f;
}

float noise_paint_edge(vec2 hashes, float y, float z, float w)
{
    return mix(noise_paint_corner(hashes.x, y, z), noise_paint_corner(hashes.y, y, z), w);
}

// Random numbers from -1 to 1 at whole-numbered places, and smoothly between. No slope exceeds 2 sqrt(3).
float noise_paint_noise(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * (vec3(3.0f) - 2.0f * f);
    float low = noise_paint_shuffle(noise_paint_remainder(base.x) + seed);
    float high = noise_paint_shuffle(noise_paint_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    float near_low = noise_paint_edge(hashes, base.y, base.z, w.x);
    float near_high = noise_paint_edge(hashes, base.y + 1.0f, base.z, w.x);
    float far_low = noise_paint_edge(hashes, base.y, base.z + 1.0f, w.x);
    float far_high = noise_paint_edge(hashes, base.y + 1.0f, base.z + 1.0f, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

Material noise_paint_material(
    vec3 p,
    vec3 first,       // #4b5d3a  Colour where the noise is small.
    vec3 second,      // #c9b98a  Colour where the noise is large.
    float size,       // 0.3 [0.001, 1000] [0.05, 5] m  Size of the clouds.
    float contrast,   // 2.0 [0, 1000] [0, 20]  From a soft blend to hard borders.
    int seed,         // 0 [0, 1000]  Another seed gives other clouds.
    float specular,   // 0.04 [0, 1]  Strength of the highlight.
    float shininess)  // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    float start = noise_paint_remainder(float(seed));
    float noise = noise_paint_noise(p / size, start);
    noise += 0.5f * noise_paint_noise(p * (2.0f / size) + vec3(0.37f), noise_paint_remainder(start + 97.0f));
    float share = clamp(0.5f + 0.5f * contrast * noise, 0.0f, 1.0f);
    return make_material(mix(first, second, share), vec3(specular), shininess, vec3(0.0f));
}
