// Custom material: rings around the y axis in two colours, yours to change.
Material custom_material_material(
    vec3 p,
    vec3 first,   // #d8b080 [0, 1]  Colour of every second ring.
    vec3 second,  // #7a4a28 [0, 1]  Colour of the rings between.
    float width)  // 0.1 [0.001, 10] [0.02, 0.5] m  Width of a ring.
{
    float ring = length(vec2(p.x, p.z)) / width;
    bool even = fract(0.5f * ring) < 0.5f;
    Material result = default_material();
    result.albedo = even ? first : second;
    return result;
}
