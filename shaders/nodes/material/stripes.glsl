// Stripes: Two colours in parallel bands.
// synonyms: bands, lines, zebra, barber, pattern
Material stripes_material(
    vec3 p,
    vec3 first,       // #d8d4c8  Colour of the band at the origin.
    vec3 second,      // #3a4450  Colour of the bands next to it.
    vec3 across,      // (0, 1, 0) [-1000, 1000] [-1, 1]  Direction across the bands; its length does not matter.
    float size,       // 0.25 [0.001, 1000] [0.05, 5] m  Distance from band to band of one colour.
    float balance,    // 0.5 [0, 1]  Share of the first colour.
    float softness,   // 0.02 [0, 1]  Share of the pattern that the borders take.
    float specular,   // 0.04 [0, 1]  Strength of the highlight.
    float shininess)  // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    float strength = length(across);
    vec3 unit = strength > 1.0e-6f ? across / max(strength, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    float turns = dot(p, unit) / size;
    float from_middle = abs(turns - floor(turns + 0.5f));
    float share = clamp((from_middle - 0.5f * balance) / max(softness, 1.0e-4f) + 0.5f, 0.0f, 1.0f);
    return make_material(mix(first, second, share), vec3(specular), shininess, vec3(0.0f));
}
