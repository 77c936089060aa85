// Point: A small lamp that shines to all sides and fades with the square of the distance.
// synonyms: lamp, bulb, omni, light
Light point_light(
    vec3 p,
    vec3 position,    // (2, 3, 2) [-1000, 1000] [-10, 10] m  Where the lamp is.
    vec3 colour,      // #ffffff  Colour of the light.
    float intensity,  // 10.0 [0, 1000000] [0, 100]  Strength of the light at a distance of one metre.
    int falloff,      // inverse_square {inverse_square, power, none}  How the light fades. Power: the intensity is all that the lamp gives, spread over the sphere around it.
    int shadow,       // hard {off, hard, soft, soft_corrected}  The edge of shadows. Corrected: without the bands of soft ones.
    float sharpness)  // 16.0 [0.5, 1000] [2, 64]  Of soft shadows: their edge is so many times narrower than it is far from what casts it.
{
    return lamp_light(position - p, colour, intensity, falloff, sharpness);
}
