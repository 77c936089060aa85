// Mask: One material over another where a number exceeds a threshold, with a soft border.
// synonyms: mask paint, layer, blend materials, mix, decal, threshold
Material mask_material(
    Material below,   // Material where the mask is small.
    Material above,   // Material where the mask is large.
    float mask,       // 0.5 [-1000000, 1000000] [0, 1]  The number; wire a noise, a distance or a position here.
    float threshold,  // 0.5 [-1000000, 1000000] [0, 1]  Number at the middle of the border.
    float softness)   // 0.1 [0, 1000000] [0, 1]  Width of the border, in the mask's numbers.
{
    float share = clamp((mask - threshold) / max(softness, 1.0e-6f) + 0.5f, 0.0f, 1.0f);
    return mix_material(below, above, share);
}
