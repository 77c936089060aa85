// Brightness: How bright a colour looks, as one number.
// synonyms: luminance, grey, desaturate, value, color
float brightness_value(
    vec3 colour)  // #808080  The colour.
{
    return dot(colour, vec3(0.2126f, 0.7152f, 0.0722f));
}
