// Point: A small lamp that shines to all sides and fades with the square of the distance.
// synonyms: lamp, bulb, omni, light
Light point_light(
    vec3 p,
    vec3 position,    // (2, 3, 2) [-1000, 1000] [-10, 10] m  Where the lamp is.
    vec3 colour,      // #ffffff  Colour of the light.
    float intensity,  // 10.0 [0, 1000000] [0, 100]  Strength of the light at a distance of one metre.
    bool shadow)      // true  Cast hard shadows.
{
    vec3 way = position - p;
    float range = max(length(way), 1.0e-3f);
    Light light;
    light.direction = way / range;
    light.range = range;
    light.radiance = colour * (intensity / (range * range));
    return light;
}
