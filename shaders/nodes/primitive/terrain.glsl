// Terrain: Endless hills and valleys, finer and finer ones on each other.
// field: bound
// synonyms: landscape, fbm, mountains, hills, heightfield
const float TERRAIN_PRIME = 1013.0f;

// The remainder of a whole number from 0 to 2^20; exact in 24 bits, so the same on every machine.
float terrain_remainder(float x)
{
    float rest = x - TERRAIN_PRIME * floor(x / TERRAIN_PRIME);
    rest = rest < 0.0f ? rest + TERRAIN_PRIME : rest;
    return rest < TERRAIN_PRIME ? rest : rest - TERRAIN_PRIME;
}

// Cubing shuffles the remainders of this prime without loss.
float terrain_shuffle(float x)
{
    float rest = terrain_remainder(x);
    return terrain_remainder(terrain_remainder(rest * rest) * rest);
}

float terrain_hash(float x, float y, float seed)
{
    float hash = terrain_shuffle(terrain_remainder(x) + seed + 71.0f);
    hash = terrain_shuffle(hash + terrain_remainder(y) + 157.0f);
    return terrain_shuffle(hash + 263.0f) / (TERRAIN_PRIME - 1.0f);
}

// Smooth numbers from 0 to 1 between the whole-numbered places; their slope is at most 1.5 along each axis.
float terrain_noise(vec2 q, float seed)
{
    vec2 low = floor(q);
    vec2 high = low + vec2(1.0f);
    vec2 share = q - low;
    share = share * share * (vec2(3.0f) - 2.0f * share);
    float ahead = mix(terrain_hash(low.x, low.y, seed), terrain_hash(high.x, low.y, seed), share.x);
    float behind = mix(terrain_hash(low.x, high.y, seed), terrain_hash(high.x, high.y, seed), share.x);
    return mix(ahead, behind, share.y);
}

float terrain_distance(
    vec3 p,
    float amplitude,   // 0.5 [0, 100] [0, 2] m  Height from the deepest valley to the highest peak, at most.
    float wavelength,  // 1.5 [0.01, 1000] [0.1, 10] m  Distance between the largest hills.
    int octaves,       // 5 [1, 8]  How many sizes of hills there are, each half as large as the one before.
    int seed)          // 0 [0, 1000]  Another seed gives another landscape.
{
    vec2 q = vec2(p.x, p.z) / wavelength;
    float weight = 0.5f;
    float sum = 0.0f;
    float total = 0.0f;
    for (int i = 0; i < 8; i++) {
        if (i >= octaves) {
            break;
        }
        sum = sum + weight * terrain_noise(q, float(seed) + 37.0f * float(i));
        total = total + weight;
        weight = 0.5f * weight;
        q = 2.0f * q + vec2(0.37f, 0.61f);
    }
    return p.y - amplitude * (sum / total - 0.5f);
}

// Every size of hills is as steep as the largest.
float terrain_lipschitz(float amplitude, float wavelength, int octaves)
{
    float count = float(octaves);
    float total = 1.0f - exp2(-count);
    float slope = 2.12132035f * amplitude * 0.5f * count / (wavelength * total);
    return length(vec2(1.0f, slope));
}

Box terrain_bounds()
{
    return everywhere();
}
