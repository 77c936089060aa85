// Sphere area: A glowing ball, whose shadows are the softer the larger it is.
// synonyms: area light, ball, globe, bulb, softbox, soft light, lamp
Light sphere_area_light(
    vec3 p,
    vec3 position,    // (2, 3, 2) [-1000, 1000] [-10, 10] m  Middle of the ball.
    float radius,     // 0.4 [0.001, 100] [0.01, 2] m  Radius of the ball: shadows are as soft as those of a lamp of this size.
    vec3 colour,      // #ffffff  Colour of the light.
    float intensity,  // 10.0 [0, 1000000] [0, 100]  Strength of the light at a distance of one metre.
    int falloff,      // inverse_square {inverse_square, power, none}  How the light fades. Power: the intensity is all that the lamp gives, spread over the sphere around it.
    int shadow)       // soft_corrected {off, hard, soft, soft_corrected}  The edge of shadows. Corrected: without the bands of soft ones.
{
    Light light = lamp_light(position - p, colour, intensity, falloff, 1.0f);
    // Seen from p the lamp is 2 radius / range wide, and so is the edge of a shadow seen from there.
    light.sharpness = 0.5f * light.range / radius;
    light.range = max(light.range - radius, 1.0e-3f);
    return light;
}
