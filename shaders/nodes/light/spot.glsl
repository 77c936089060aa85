// Spot: A lamp that shines in a cone.
// synonyms: spotlight, lamp, torch, flashlight, beam, cone, stage light
Light spot_light(
    vec3 p,
    vec3 position,    // (2, 4, 2) [-1000, 1000] [-10, 10] m  Where the lamp is.
    vec3 target,      // (0, 0, 0) [-1000, 1000] [-10, 10] m  Where it points.
    float angle,      // 50.0 [1, 175] [5, 120] deg  Width of the cone.
    float softness,   // 0.25 [0, 1]  Share of the cone in which the light fades to its rim.
    vec3 colour,      // #ffffff  Colour of the light.
    float intensity,  // 20.0 [0, 1000000] [0, 100]  Strength of the light at a distance of one metre, in the middle.
    int falloff,      // inverse_square {inverse_square, power, none}  How the light fades. Power: the intensity is that of a lamp that shines to all sides.
    int shadow,       // hard {off, hard, soft, soft_corrected}  The edge of shadows. Corrected: without the bands of soft ones.
    float sharpness)  // 16.0 [0.5, 1000] [2, 64]  Of soft shadows: their edge is so many times narrower than it is far from what casts it.
{
    Light light = lamp_light(position - p, colour, intensity, falloff, sharpness);
    vec3 way = target - position;
    float along = -dot(light.direction, way) / max(length(way), 1.0e-6f);
    float rim = cos(0.5f * angle);
    float full = max(cos(0.5f * angle * (1.0f - softness)), rim + 1.0e-4f);
    light.radiance = light.radiance * smoothstep(rim, full, along);
    return light;
}
