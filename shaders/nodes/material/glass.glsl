// Glass: Lets light through and bends it, as glass, water and gems do, and mirrors the more, the flatter one looks at it
// (Fresnel's equations as approximated by Schlick). Needs bounces in the scene's settings: two to see through a solid.
// Without bounces it looks like paint of its colour.
// synonyms: transparent, refraction, refractive, water, crystal, diamond, dielectric, window, ice, gem
Material glass_material(
    float refraction_index,  // 1.5 [1, 4] [1, 2.5]  How much light is bent: water 1.33, glass 1.5, diamond 2.4.
    vec3 colour,             // #ddeee8  Colour that white light has after the depth.
    float depth,             // 0.5 [0.001, 1000] [0.05, 5] m  Way through the glass after which light has that colour.
    float transmission,      // 1.0 [0, 1]  Share of the light that goes in; the rest is scattered, as by milk.
    float specular,          // 0.5 [0, 1]  Strength of the highlight.
    float shininess,         // 300.0 [1, 2000] [1, 1000]  Sharpness of the highlight: larger makes it smaller.
    int shadow)              // transmitted {full, transmitted, none}  Its shadow: as of something opaque, of what does not come through, or none at all.
{
    vec3 absorption = -log(clamp(colour, vec3(1.0e-3f), vec3(1.0f))) / depth;
    Material material = make_material(colour, vec3(specular), shininess, vec3(0.0f));
    return with_shadow(with_transmission(material, transmission, refraction_index, absorption), shadow);
}
