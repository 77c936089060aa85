// Random: A random number for each whole-numbered place, such as each cell of a repeat.
// synonyms: hash, noise, variation, chance, dice
const float RANDOM_PRIME = 1013.0f;

// The remainder of a whole number within 2^21 of 0. Exact in 24 bits, so the same on every machine: the added half keeps
// quotients farther from whole numbers than they are rounded.
float random_remainder(float x)
{
    return x - RANDOM_PRIME * floor((x + 0.5f) * (1.0f / RANDOM_PRIME));
}

// Cubing shuffles the remainders of this prime without loss; x within 1448 of 0.
float random_shuffle(float x)
{
    return random_remainder(random_remainder(x * x) * x);
}

float random_hash(vec3 whole, float seed)
{
    float hash = random_shuffle(random_remainder(seed) - 624.0f);
    hash = random_shuffle(hash + random_remainder(whole.x) - 942.0f);
    hash = random_shuffle(hash + random_remainder(whole.y) - 856.0f);
    hash = random_shuffle(hash + random_remainder(whole.z) - 750.0f);
    return random_shuffle(random_shuffle(hash + 97.0f) + 331.0f);
}

float random_value(
    vec3 place,     // (0, 0, 0) [-1000000, 1000000] [-10, 10]  Where; rounded to whole numbers. Wire a cell here.
    int seed,       // 0 [0, 1000]  Another seed gives other numbers.
    float minimum,  // 0.0 [-1000000, 1000000] [-10, 10]  Smallest number.
    float maximum)  // 1.0 [-1000000, 1000000] [-10, 10]  Largest number.
{
    vec3 whole = floor(place + vec3(0.5f));
    float coarse = random_hash(whole, float(seed));
    float fine = random_hash(whole, float(seed) + 503.0f);
    return mix(minimum, maximum, (coarse + fine / RANDOM_PRIME) / RANDOM_PRIME);
}
