// Picture: the entry point that Shadertoy calls.

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    time = iTime;
    update_frame();
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    int ray_count = 1 + SHADOW_COUNT + min(iFrame, 0);
    Ray ray = scene_ray(uv, vec2(0.0));
#if COVERAGE
    float pixel_size = 2.0 / iResolution.y;
    Ray beside = scene_ray(uv + vec2(pixel_size, 0.0), vec2(0.0));
    Ray above = scene_ray(uv + vec2(0.0, pixel_size), vec2(0.0));
    Footprint footprint = make_footprint(ray, beside, above);
#endif
    Pixel pixel = trace_pixel(ray,
#if COVERAGE
                              footprint, shown_sky(),
#endif
                              MARCH,
#if FOG
                              FOG,
#endif
                              STEP_BUDGET, ray_count);
    fragColor = shown_pixel(pixel);
}
