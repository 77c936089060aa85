// HSV colour: A colour from its hue, its saturation and its brightness, its value.
// synonyms: hsb, hue, rainbow, make colour, color, tint
float hsv_colour_channel(float turns)
{
    return clamp(abs(6.0f * (turns - floor(turns)) - 3.0f) - 1.0f, 0.0f, 1.0f);
}

vec3 hsv_colour_value(
    float hue,         // 0.0 [-1000000, 1000000] [0, 1]  Turns around the colour wheel; 0 is red, a third is green.
    float saturation,  // 0.8 [0, 1]  From grey to the pure colour.
    float brightness)  // 0.8 [0, 1000] [0, 1]  From black to full brightness.
{
    float green = hsv_colour_channel(hue + 0.66666667f);
    float blue = hsv_colour_channel(hue + 0.33333333f);
    vec3 pure = vec3(hsv_colour_channel(hue), green, blue);
    return brightness * mix(vec3(1.0f), pure, saturation);
}
