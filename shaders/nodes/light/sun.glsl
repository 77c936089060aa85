// Sun: Parallel light from far away. A white sun of 1 that shines straight onto a surface shows its colour.
// synonyms: directional, daylight, parallel, key light
Light sun_light(
    vec3 p,
    float elevation,  // 45.0 [-90, 90] deg  Height above the horizon.
    float azimuth,    // 35.0 [-360, 360] [-180, 180] deg  Turn around y: 0 is in front (+z), 90 to the right (+x).
    vec3 colour,      // #fff4e5  Colour of the light.
    float intensity,  // 1.0 [0, 1000] [0, 5]  Strength of the light.
    int shadow,       // hard {off, hard, soft, soft_corrected}  The edge of shadows. Corrected: without the bands of soft ones.
    float sharpness)  // 16.0 [0.5, 1000] [2, 64]  Of soft shadows: their edge is so many times narrower than it is far from what casts it.
{
    Light light;
    light.direction = vec3(cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth));
    light.range = UNBOUNDED;
    light.radiance = colour * intensity;
    light.sharpness = sharpness;
    return light;
}
