// Vector: Three numbers as one vector.
// synonyms: combine xyz, vec3, make vector
vec3 vector_value(
    float x,  // 0.0 [-1000000, 1000000] [-10, 10]  First component.
    float y,  // 0.0 [-1000000, 1000000] [-10, 10]  Second component.
    float z)  // 0.0 [-1000000, 1000000] [-10, 10]  Third component.
{
    return vec3(x, y, z);
}
