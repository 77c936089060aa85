// Vector subtract: One vector minus another.
// synonyms: minus, difference, from to, vector
vec3 vector_subtract_value(
    vec3 first,   // (0, 0, 0) [-1000000, 1000000] [-10, 10]  Vector that is taken from.
    vec3 second)  // (0, 0, 0) [-1000000, 1000000] [-10, 10]  Vector that is taken away.
{
    return first - second;
}
