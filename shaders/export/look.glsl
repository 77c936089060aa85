// Look: what a screen shows of a pixel, with the scene's backdrop, exposure and tone map.

vec3 tone_map(vec3 colour)
{
    if (TONE_MAP == 1) return tone_map_neutral(colour);
    if (TONE_MAP == 2) return tone_map_agx(colour);
    if (TONE_MAP == 3) return tone_map_aces(colour);
    return colour;
}

#if COVERAGE
// Of a backdrop that is none of the sky, no eye ray brings light.
float shown_sky()
{
    return BACKDROP > 0 ? 0.0 : 1.0;
}

vec4 shown_pixel(Pixel pixel)
{
    float alpha = BACKDROP == 2 ? pixel.covered : 1.0;
    float open = BACKDROP == 1 ? 1.0 - pixel.covered : 0.0;
    vec3 colour = (pixel.colour + open * BACKDROP_COLOUR) / max(alpha, 1.0e-6);
    vec3 shown = tone_map(expose(colour, EXPOSURE));
    return vec4(srgb_encode(clamp(shown, vec3(0.0), vec3(1.0))), alpha);
}
#else
vec4 shown_pixel(Pixel pixel)
{
    bool missed = pixel.depth < 0.0;
    vec3 colour = missed && BACKDROP > 0 ? BACKDROP_COLOUR : pixel.colour;
    vec3 shown = tone_map(expose(colour, EXPOSURE));
    return vec4(srgb_encode(clamp(shown, vec3(0.0), vec3(1.0))), missed && BACKDROP == 2 ? 0.0 : 1.0);
}
#endif
