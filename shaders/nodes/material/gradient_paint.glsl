// Gradient paint: One colour that passes into another along an axis.
// synonyms: ramp, fade, two-tone, height, pattern
Material gradient_paint_material(
    vec3 p,
    vec3 first,       // #1f4e79  Colour before the start.
    vec3 second,      // #e8a33d  Colour after the end.
    int axis,         // y {x, y, z}  Axis along which the colour changes.
    float start,      // -0.5 [-1000, 1000] [-5, 5] m  Where the change begins.
    float end,        // 0.5 [-1000, 1000] [-5, 5] m  Where it ends; may lie below the start.
    float specular,   // 0.04 [0, 1]  Strength of the highlight.
    float shininess)  // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    float place = axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
    float span = end - start;
    float share = abs(span) < 1.0e-6f ? (place < start ? 0.0f : 1.0f) : clamp((place - start) / span, 0.0f, 1.0f);
    return make_material(mix(first, second, share), vec3(specular), shininess, vec3(0.0f));
}
