// Vector add: The sum of two vectors.
// synonyms: plus, sum, translate, vector
vec3 vector_add_value(
    vec3 first,   // (0, 0, 0) [-1000000, 1000000] [-10, 10]  First vector.
    vec3 second)  // (0, 0, 0) [-1000000, 1000000] [-10, 10]  Second vector.
{
    return first + second;
}
