// Phong: A coloured surface with a highlight, a glow of its own, and as much of a mirror as you like.
// synonyms: colour, color, plastic, matte, shiny, glow, emission, mirror, varnish
Material phong_material(
    vec3 albedo,      // #c8503c  Colour in white light.
    float specular,   // 0.15 [0, 1]  Strength of the highlight.
    float shininess,  // 40.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
    vec3 glow,        // #ffffff  Colour of the surface's own light.
    float emission,   // 0.0 [0, 1000] [0, 5]  Strength of the surface's own light.
    float reflection) // 0.0 [0, 1]  Share of what is around that it mirrors, seen straight on; needs bounces.
{
    return with_reflection(make_material(albedo, vec3(specular), shininess, glow * emission), vec3(reflection));
}
