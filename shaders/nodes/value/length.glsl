// Length: The length of a vector.
// synonyms: magnitude, norm, size, vector
float length_value(
    vec3 vector)  // (1, 0, 0) [-1000000, 1000000] [-10, 10]  The vector.
{
    return length(vector);
}
