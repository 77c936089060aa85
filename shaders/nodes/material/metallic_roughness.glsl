// Metallic roughness: A surface described as game engines and glTF do: from matte to mirror-like, plastic or metal.
// The highlight is that of microfacets (Trowbridge and Reitz), brighter at grazing angles (Schlick). Where the scene has
// bounces, smooth surfaces mirror what is around them; without, the sky.
// synonyms: pbr, physically based, metal, ggx, principled, gold, chrome, gltf
Material metallic_roughness_material(
    vec3 base_colour,  // #d9a441  Colour in white light; of metals, the colour of their reflection.
    float metallic,    // 1.0 [0, 1]  0 is plastic, wood or stone; 1 is bare metal.
    float roughness,   // 0.35 [0.03, 1]  Small makes highlights small and bright, 1 makes the surface matte.
    vec3 glow,         // #ffffff  Colour of the surface's own light.
    float emission)    // 0.0 [0, 1000] [0, 5]  Strength of the surface's own light.
{
    Material material = make_material(base_colour * (1.0f - metallic), mix(vec3(0.04f), base_colour, metallic), 1.0f,
                                      glow * emission);
    return with_microfacets(material, roughness);
}
