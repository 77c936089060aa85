// Picture: the entry point that Shadertoy calls.

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    time = iTime;
    update_frame();
    vec2 uv = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    Pixel pixel = trace_pixel(scene_ray(uv), MARCH, STEP_BUDGET, 1 + SHADOW_COUNT + min(iFrame, 0));
    fragColor = vec4(srgb_encode(clamp(pixel.colour, vec3(0.0), vec3(1.0))), 1.0);
}
