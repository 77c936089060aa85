// Dots: Balls of one colour in another, on a regular grid.
// synonyms: polka, spots, points, ladybird, pattern
Material dots_material(
    vec3 p,
    vec3 first,       // #d8d4c8  Colour between the dots.
    vec3 second,      // #c8503c  Colour of the dots.
    float size,       // 0.25 [0.001, 1000] [0.05, 5] m  Distance from dot to dot.
    float radius,     // 0.35 [0, 1] [0, 0.6]  Radius of the dots, as a share of that distance.
    float softness,   // 0.02 [0, 1]  Share of the pattern that the borders take.
    float specular,   // 0.04 [0, 1]  Strength of the highlight.
    float shininess)  // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    vec3 q = p / size;
    float from_middle = length(q - floor(q + vec3(0.5f)));
    float share = 1.0f - clamp((from_middle - radius) / max(softness, 1.0e-4f) + 0.5f, 0.0f, 1.0f);
    return make_material(mix(first, second, share), vec3(specular), shininess, vec3(0.0f));
}
