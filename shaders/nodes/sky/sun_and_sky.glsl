// Sun and sky: A clear sky as the sun's height makes it: blue above, pale at the horizon, red when the sun is low.
// synonyms: daylight, atmosphere, physical sky, sunset, dusk, dawn, outdoor, background, environment
// follows: sun while follow_sun
// switch follow_sun: true older false  Takes its elevation and azimuth from the scene's first sun light, animated ones too. Off in scenes from before this switch.

// Optical depth of the whole air straight up, at 680, 550 and 440 nm.
const vec3 SUN_AND_SKY_AIR = vec3(0.0464f, 0.108f, 0.265f);

// What ozone takes of sunlight on such a way; it scatters nothing.
const vec3 SUN_AND_SKY_OZONE = vec3(0.020f, 0.027f, 0.001f);

// Airs in the way at that height above the horizon, given as its sine (G. V. Rozenberg, "Twilight", 1966).
float sun_and_sky_airs(float height)
{
    float above = max(height, 0.0f);
    return 1.0f / (above + 0.025f * exp(-11.0f * above));
}

vec3 sun_and_sky_kept(vec3 depth, float airs)
{
    return exp(depth * (-airs));
}

// Light that air (by Rayleigh) and haze (by the phase function of Henyey and Greenstein, forwardness 0.76) scatter once,
// and a share of what they scatter again, which brings the horizon to white.
vec3 sun_and_sky_air(vec3 direction, vec3 sun, float haze)
{
    vec3 hazy = vec3(0.02f * haze);
    vec3 depth = SUN_AND_SKY_AIR + hazy;
    float along = dot(direction, sun);
    float air_phase = 0.1875f * (1.0f + along * along);
    float haze_phase = 0.1056f / pow(1.5776f - 1.52f * along, 1.5f);
    vec3 scattered = (SUN_AND_SKY_AIR * air_phase + hazy * haze_phase) / depth;
    float sun_airs = sun_and_sky_airs(sun.y);
    vec3 reaching = sun_and_sky_kept(depth + SUN_AND_SKY_OZONE, 0.6f * min(sun_airs, 38.0f));
    vec3 again = vec3(0.12f) * sun_and_sky_kept(depth + SUN_AND_SKY_OZONE, min(sun_airs, 38.0f));
    float day = smoothstep(-0.3f, 0.05f, sun.y);
    vec3 filled = vec3(1.0f) - sun_and_sky_kept(depth, sun_and_sky_airs(direction.y));
    return day * filled * (scattered * reaching + again);
}

vec3 sun_and_sky_sky(
    vec3 direction,
    float spread,
    float elevation,  // 45.0 [-90, 90] deg  Height of the sun above the horizon; as that of a sun light, whose angles count while it follows one.
    float azimuth,    // 35.0 [-360, 360] [-180, 180] deg  Turn of the sun around y: 0 is in front (+z), 90 to the right (+x).
    float haze,       // 1.0 [0, 50] [0, 10]  How much dust and mist is in the air.
    float disc,       // 2.0 [0, 30] [0, 5] deg  How wide the sun is; the real one is half a degree. 0 hides it.
    vec3 ground,      // #7d766a  Colour below the horizon, in full sunlight.
    float strength)   // 3.0 [0, 1000] [0, 10]  Brightness of the sky. 1 is that beside a sun of 1 above the air.
{
    vec3 sun = vec3(cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth));
    vec3 above = vec3(direction.x, max(direction.y, 0.0f), direction.z);
    vec3 sky = strength * sun_and_sky_air(above / max(length(above), 1.0e-6f), sun, haze);
    vec3 depth = SUN_AND_SKY_AIR + SUN_AND_SKY_OZONE + vec3(0.02f * haze);
    vec3 sunlight = sun_and_sky_kept(depth, sun_and_sky_airs(sun.y));

    // A look that gathers much of the sky leaves the disc to the sun's own light.
    float rim = cos(0.5f * disc);
    float seen = smoothstep(rim, rim + 0.25f * (1.0f - rim) + 1.0e-7f, dot(direction, sun));
    float sharp = 1.0f - smoothstep(0.0f, 0.05f, spread);
    vec3 glare = (disc > 0.0f ? 20.0f : 0.0f) * seen * sharp * sunlight;

    vec3 zenith = sun_and_sky_air(vec3(0.0f, 1.0f, 0.0f), sun, haze);
    vec3 earth = ground * (sunlight * max(sun.y, 0.0f) + 0.1f * strength * zenith);
    // Far ground fades into the horizon; a look that gathers much sees both sides of it.
    float below = max(-direction.y, 1.0e-3f);
    vec3 far_earth = mix(sky, earth, exp(-0.04f * haze / below));
    return mix(sky + glare, far_earth, smoothstep(-0.6f * spread, 0.004f + 0.6f * spread, -direction.y));
}
