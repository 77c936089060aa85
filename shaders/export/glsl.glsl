// Picture: the main function of an exported fragment shader.

out vec4 colour_out;

void main()
{
    update_frame();
    vec2 uv = (2.0 * gl_FragCoord.xy - resolution) / resolution.y;
    int ray_count = 1 + SHADOW_COUNT + min(int(resolution.x), 0);
#if FOG
    Pixel pixel = trace_pixel(scene_ray(uv, vec2(0.0)), MARCH, FOG, STEP_BUDGET, ray_count);
#else
    Pixel pixel = trace_pixel(scene_ray(uv, vec2(0.0)), MARCH, STEP_BUDGET, ray_count);
#endif
    colour_out = shown_pixel(pixel);
}
