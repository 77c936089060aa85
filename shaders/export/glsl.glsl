// Picture: the main function of an exported fragment shader.

out vec4 colour_out;

void main()
{
    update_frame();
    vec2 uv = (2.0 * gl_FragCoord.xy - resolution) / resolution.y;
    Pixel pixel = trace_pixel(scene_ray(uv), MARCH, STEP_BUDGET, 1 + SHADOW_COUNT + min(int(resolution.x), 0));
    colour_out = vec4(srgb_encode(clamp(pixel.colour, vec3(0.0), vec3(1.0))), 1.0);
}
