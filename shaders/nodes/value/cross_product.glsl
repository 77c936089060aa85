// Cross product: The vector at right angles to two others.
// synonyms: vector product, normal, perpendicular, vector
vec3 cross_product_value(
    vec3 first,   // (1, 0, 0) [-1000000, 1000000] [-10, 10]  First vector.
    vec3 second)  // (0, 1, 0) [-1000000, 1000000] [-10, 10]  Second vector.
{
    return cross(first, second);
}
