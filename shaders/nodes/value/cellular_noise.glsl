// Cellular noise: How far it is to the nearest of many scattered points, like cells under a microscope.
// synonyms: worley, voronoi, cells, stones, scales, cracks

// The remainder of a whole number by 289; half a step aside of every jump, so the same on every machine.
float cellular_noise_remainder(float x)
{
    return x - 289.0f * floor((x + 0.5f) / 289.0f);
}

// A polynomial that permutes the remainders (Gustavson and McEwan 2012).
float cellular_noise_shuffle(float x)
{
    return cellular_noise_remainder(cellular_noise_remainder(34.0f * x + 1.0f) * x);
}

// Squared distance to the random point of a cell.
float cellular_noise_to_point(vec3 q, vec3 cell, float seed)
{
    float hash = cellular_noise_shuffle(cellular_noise_remainder(cell.x) + seed);
    hash = cellular_noise_shuffle(hash + cellular_noise_remainder(cell.y));
    float first = cellular_noise_shuffle(hash + cellular_noise_remainder(cell.z));
    float second = cellular_noise_shuffle(first + 71.0f);
    float third = cellular_noise_shuffle(second + 157.0f);
    vec3 way = cell + (vec3(first, second, third) + vec3(0.5f)) / 289.0f - q;
    return dot(way, way);
}

// The nearest of three cells in a row.
float cellular_noise_row(vec3 q, vec3 cell, float seed)
{
    vec3 x = vec3(1.0f, 0.0f, 0.0f);
    return min(cellular_noise_to_point(q, cell, seed),
               min(cellular_noise_to_point(q, cell - x, seed), cellular_noise_to_point(q, cell + x, seed)));
}

float cellular_noise_layer(vec3 q, vec3 cell, float seed)
{
    vec3 y = vec3(0.0f, 1.0f, 0.0f);
    float beside = min(cellular_noise_row(q, cell - y, seed), cellular_noise_row(q, cell + y, seed));
    return min(cellular_noise_row(q, cell, seed), beside);
}

float cellular_noise_nearest(vec3 q, float seed)
{
    vec3 cell = floor(q);
    vec3 z = vec3(0.0f, 0.0f, 1.0f);
    float beside = min(cellular_noise_layer(q, cell - z, seed), cellular_noise_layer(q, cell + z, seed));
    return sqrt(min(cellular_noise_layer(q, cell, seed), beside));
}

float cellular_noise_value(
    vec3 p,
    vec3 shift,     // (0, 0, 0) [-1000000, 1000000] [-5, 5] m  Moves the pattern; wire time here to let it flow.
    float size,     // 0.5 [0.001, 1000] [0.05, 5] m  Size of the pattern.
    int seed,       // 0 [0, 1000]  Another seed gives another pattern.
    float minimum,  // 0.0 [-1000000, 1000000] [-10, 10]  Result at the smallest.
    float maximum)  // 1.0 [-1000000, 1000000] [-10, 10]  Result at the largest.
{
    vec3 q = (p - shift) / size;
    float start = cellular_noise_remainder(float(seed));
    return mix(minimum, maximum, min(cellular_noise_nearest(q, start), 1.0f));
}
