// Gradient: A sky that fades from the horizon to the zenith, with a ground colour below.
// synonyms: background, environment, backdrop, horizon
vec3 gradient_sky(
    vec3 direction,
    vec3 zenith,     // #4f7fc4  Colour straight above.
    vec3 horizon,    // #cfdbe6  Colour at the horizon.
    vec3 ground,     // #6b665e  Colour straight below.
    float strength)  // 1.0 [0, 1000] [0, 5]  Brightness of the whole sky.
{
    float above = smoothstep(0.0f, 0.7f, direction.y);
    float below = smoothstep(0.0f, 0.5f, -direction.y);
    return mix(mix(horizon, zenith, above), ground, below) * strength;
}
