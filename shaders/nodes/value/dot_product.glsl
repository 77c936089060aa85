// Dot product: How far two vectors point the same way.
// synonyms: scalar product, projection, cosine, vector
float dot_product_value(
    vec3 first,   // (1, 0, 0) [-1000000, 1000000] [-10, 10]  First vector.
    vec3 second)  // (1, 0, 0) [-1000000, 1000000] [-10, 10]  Second vector.
{
    return dot(first, second);
}
