// Random: A random number for each whole-numbered place, such as each cell of a repeat.
// synonyms: hash, noise, variation, chance, dice
const float RANDOM_PRIME = 1013.0f;

// The remainder of a whole number from 0 to 2^20; exact in 24 bits, so the same on every machine.
float random_remainder(float x)
{
    float rest = x - RANDOM_PRIME * floor(x / RANDOM_PRIME);
    rest = rest < 0.0f ? rest + RANDOM_PRIME : rest;
    return rest < RANDOM_PRIME ? rest : rest - RANDOM_PRIME;
}

// Cubing shuffles the remainders of this prime without loss.
float random_shuffle(float x)
{
    float rest = random_remainder(x);
    return random_remainder(random_remainder(rest * rest) * rest);
}

float random_hash(vec3 whole, float seed)
{
    float hash = random_shuffle(random_remainder(seed) + 389.0f);
    hash = random_shuffle(hash + random_remainder(whole.x) + 71.0f);
    hash = random_shuffle(hash + random_remainder(whole.y) + 157.0f);
    hash = random_shuffle(hash + random_remainder(whole.z) + 263.0f);
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
