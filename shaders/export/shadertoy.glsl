// Picture: the entry point that Shadertoy calls.

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    time = iTime;
    update_frame();
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    int ray_count = 1 + SHADOW_COUNT + min(iFrame, 0);
#if FOG
    Pixel pixel = trace_pixel(scene_ray(uv, vec2(0.0)), MARCH, FOG, STEP_BUDGET, ray_count);
#else
    Pixel pixel = trace_pixel(scene_ray(uv, vec2(0.0)), MARCH, STEP_BUDGET, ray_count);
#endif
    fragColor = shown_pixel(pixel);
}
