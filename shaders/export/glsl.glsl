// Picture: the main function of an exported fragment shader.

out vec4 colour_out;

void main()
{
    update_frame();
    vec2 uv = (2.0 * gl_FragCoord.xy - resolution) / resolution.y;
    int ray_count = 1 + SHADOW_COUNT + min(int(resolution.x), 0);
    Pixel pixel = pixel_at(uv, 2.0 / resolution.y, ray_count);
    colour_out = shown_pixel(pixel);
}
