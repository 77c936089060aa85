// Normalise: The vector of length 1 that points the same way; 0 stays 0.
// synonyms: normalize, unit vector, direction, vector
vec3 normalise_value(
    vec3 vector)  // (1, 0, 0) [-1000000, 1000000] [-10, 10]  The vector.
{
    return vector / max(length(vector), 1.0e-12f);
}
