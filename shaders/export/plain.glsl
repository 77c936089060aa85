// Plain: what a screen shows of a pixel, as its light is.

#if COVERAGE
float shown_sky()
{
    return 1.0;
}

#endif
vec4 shown_pixel(Pixel pixel)
{
    return vec4(srgb_encode(clamp(pixel.colour, vec3(0.0), vec3(1.0))), 1.0);
}
