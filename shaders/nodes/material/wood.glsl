// Wood: Growth rings around an axis, bent by noise, with fine fibres along it.
// synonyms: timber, grain, rings, planks, oak, pattern

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float wood_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float wood_shuffle(float x)
{
    return wood_remainder(wood_remainder(34.0f * x + 1.0f) * x);
}

float wood_corner(float hash, float y, float z)
{
    float mixed = wood_shuffle(hash + wood_remainder(y));
    return wood_shuffle(mixed + wood_remainder(z)) / 144.0f - 1.0f;
}

float wood_edge(vec2 hashes, float y, float z, float w)
{
    return mix(wood_corner(hashes.x, y, z), wood_corner(hashes.y, y, z), w);
}

// Random numbers from -1 to 1 at whole-numbered places, and smoothly between. No slope exceeds 2 sqrt(3).
float wood_noise(vec3 q, float seed)
{
    vec3 base = floor(q);
    vec3 f = q - base;
    vec3 w = f * f * (vec3(3.0f) - 2.0f * f);
    float low = wood_shuffle(wood_remainder(base.x) + seed);
    float high = wood_shuffle(wood_remainder(base.x + 1.0f) + seed);
    vec2 hashes = vec2(low, high);
    float near_low = wood_edge(hashes, base.y, base.z, w.x);
    float near_high = wood_edge(hashes, base.y + 1.0f, base.z, w.x);
    float far_low = wood_edge(hashes, base.y, base.z + 1.0f, w.x);
    float far_high = wood_edge(hashes, base.y + 1.0f, base.z + 1.0f, w.x);
    return mix(mix(near_low, near_high, w.y), mix(far_low, far_high, w.y), w.z);
}

Material wood_material(
    vec3 p,
    vec3 first,       // #b98a56  Colour of the early wood.
    vec3 second,      // #6f4526  Colour of the late wood, at the rings.
    int axis,         // y {x, y, z}  Axis along which the tree grew.
    float size,       // 0.12 [0.001, 1000] [0.05, 5] m  Distance from ring to ring.
    float waviness,   // 0.5 [0, 100] [0, 3]  How far the rings are bent, in rings.
    float fibre,      // 0.25 [0, 1]  Strength of the fibres.
    int seed,         // 0 [0, 1000]  Another seed gives another tree.
    float specular,   // 0.04 [0, 1]  Strength of the highlight.
    float shininess)  // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    vec3 v = axis == 0 ? vec3(p.y, p.x, p.z) : (axis == 1 ? p : vec3(p.x, p.z, p.y));
    vec3 q = vec3(v.x, 0.25f * v.y, v.z) / size;
    float start = wood_remainder(float(seed));
    float bend = waviness * wood_noise(0.4f * q, start);
    float rings = length(vec2(q.x, q.z)) + bend;
    float late = rings - floor(rings);
    float fibres = wood_noise(vec3(12.0f * q.x, q.y, 12.0f * q.z), wood_remainder(start + 97.0f));
    float ring = late * late * clamp((1.0f - late) * 8.0f, 0.0f, 1.0f) * 1.6f;
    float share = clamp(ring + 0.5f * fibre * fibres, 0.0f, 1.0f);
    return make_material(mix(first, second, share), vec3(specular), shininess, vec3(0.0f));
}
