// Look: what a screen shows of a pixel, with the scene's backdrop, exposure and tone map.

vec3 tone_map(vec3 colour)
{
    if (TONE_MAP == 1) return tone_map_neutral(colour);
    if (TONE_MAP == 2) return tone_map_agx(colour);
    if (TONE_MAP == 3) return tone_map_aces(colour);
    return colour;
}

vec4 shown_pixel(Pixel pixel)
{
    bool missed = pixel.depth < 0.0;
    vec3 colour = missed && BACKDROP > 0 ? BACKDROP_COLOUR : pixel.colour;
    vec3 shown = tone_map(expose(colour, EXPOSURE));
    return vec4(srgb_encode(clamp(shown, vec3(0.0), vec3(1.0))), missed && BACKDROP == 2 ? 0.0 : 1.0);
}
