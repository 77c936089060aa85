// Picture: the entry point that Shadertoy calls.

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    time = iTime;
    update_frame();
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    int ray_count = 1 + SHADOW_COUNT + min(iFrame, 0);
    Pixel pixel = pixel_at(uv, 2.0 / iResolution.y, ray_count);
    fragColor = shown_pixel(pixel);
}
