// Vector scale: A vector times a number.
// synonyms: multiply, lengthen, times, vector
vec3 vector_scale_value(
    vec3 vector,   // (1, 0, 0) [-1000000, 1000000] [-10, 10]  The vector.
    float factor)  // 1.0 [-1000000, 1000000] [-10, 10]  What it is multiplied by.
{
    return vector * factor;
}
