// Gradient: A sky that fades from the horizon to the zenith, with a ground colour below.
// synonyms: background, environment, backdrop, horizon
vec3 gradient_sky(
    vec3 direction,
    vec3 zenith,     // #4f7fc4  Colour straight above.
    vec3 horizon,    // #dfe8f2  Colour at the horizon.
    vec3 ground,     // #6b665e  Colour straight below.
    float strength)  // 1.0 [0, 1000] [0, 5]  Brightness of the whole sky.
{
    float above = sqrt(clamp(direction.y, 0.0f, 1.0f));
    float below = sqrt(clamp(-direction.y, 0.0f, 1.0f));
    return mix(mix(horizon, zenith, above), ground, below) * strength;
}
