// Combine colour: A colour from its red, green and blue, in linear light.
// synonyms: rgb, make colour, color, join, channels
vec3 combine_colour_value(
    float red,    // 0.8 [0, 1000] [0, 1]  Amount of red.
    float green,  // 0.4 [0, 1000] [0, 1]  Amount of green.
    float blue)   // 0.2 [0, 1000] [0, 1]  Amount of blue.
{
    return vec3(red, green, blue);
}
