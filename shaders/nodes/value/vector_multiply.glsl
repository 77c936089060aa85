// Vector multiply: Two vectors multiplied component by component.
// synonyms: times, product, scale axes, tint, vector
vec3 vector_multiply_value(
    vec3 first,   // (1, 1, 1) [-1000000, 1000000] [-10, 10]  First vector.
    vec3 second)  // (1, 1, 1) [-1000000, 1000000] [-10, 10]  Second vector.
{
    return first * second;
}
