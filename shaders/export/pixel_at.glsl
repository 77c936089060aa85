// What the camera sees in one direction: uv as main functions give it, and how wide a pixel is there.
Pixel pixel_at(vec2 uv, float pixel_size, int ray_count)
{
    Ray ray = scene_ray(uv, vec2(0.0));
#if COVERAGE
    Ray beside = scene_ray(uv + vec2(pixel_size, 0.0), vec2(0.0));
    Ray above = scene_ray(uv + vec2(0.0, pixel_size), vec2(0.0));
    Footprint footprint = make_footprint(ray, beside, above);
#endif
    return trace_pixel(ray,
#if COVERAGE
                       footprint, shown_sky(),
#endif
                       MARCH,
#if FOG
                       FOG,
#endif
                       STEP_BUDGET, ray_count);
}
