// Soften: Blurs a solid's distance, which rounds edges outwards and fills corners inwards.
// The mean of the distances at eight places around the point. Eight times the cost of what is below it.
// field: bound
// synonyms: blur, smooth, relax, melt, round edges, average
// copies: 8
vec3 soften_point(
    vec3 p,
    float size,  // 0.12 [0, 10] [0, 0.5] m  How far along each axis the distances are taken.
    int copy)
{
    float x = copy % 2 == 0 ? -size : size;
    float y = copy / 2 % 2 == 0 ? -size : size;
    float z = copy < 4 ? -size : size;
    return p + vec3(x, y, z);
}

// The fold begins with a distance that no sum reaches.
float soften_distance(float acc, float d)
{
    return acc > 0.9f * UNBOUNDED ? 0.125f * d : acc + 0.125f * d;
}

Box soften_bounds(float size, Box child)
{
    return grow_box(child, 1.7321f * size);
}
