// Checker: Two colours that alternate in cubes, centred on the origin.
// synonyms: chess, tiles, squares, pattern, grid
Material checker_material(
    vec3 p,
    vec3 first,       // #d8d4c8  Colour of the cube at the origin.
    vec3 second,      // #3a4450  Colour of the cubes next to it.
    float size,       // 0.5 [0.001, 1000] [0.05, 5] m  Length of the cubes' edges.
    float specular,   // 0.04 [0, 1]  Strength of the highlight.
    float shininess)  // 32.0 [1, 2000] [1, 200]  Sharpness of the highlight: larger makes it smaller.
{
    vec3 cube = floor(p / size + vec3(0.5f));
    float half_sum = 0.5f * (cube.x + cube.y + cube.z);
    return make_material(half_sum - floor(half_sum) < 0.25f ? first : second, vec3(specular), shininess, vec3(0.0f));
}
