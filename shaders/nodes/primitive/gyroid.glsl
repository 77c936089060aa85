// Gyroid: A wall that winds through space and parts it into two equal mazes.
// field: bound
// synonyms: minimal surface, infill, lattice, labyrinth
float gyroid_distance(
    vec3 p,
    float period,      // 0.8 [0.01, 100] [0.1, 5] m  Distance after which the surface repeats.
    float thickness,   // 0.06 [0.001, 10] [0.01, 0.5] m  Thickness of the wall where it is thinnest.
    float radius,      // 0.9 [0.001, 1000] [0.05, 5] m  Radius of the ball, or half the edges of the block.
    int boundary)      // ball {ball, block}  What the surface is cut out of.
{
    vec3 q = p * (6.28318531f / period);
    vec3 s = sin(q);
    vec3 c = cos(q);
    // The slope of this wave is at most the root of 3.
    float wave = s.x * c.y + s.y * c.z + s.z * c.x;
    float wall = abs(wave) * period / (6.28318531f * 1.73205081f) - 0.5f * thickness;
    vec3 beyond = abs(p) - vec3(radius);
    float block = length(max(beyond, vec3(0.0f))) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0f);
    return max(wall, boundary == 0 ? length(p) - radius : block);
}

Box gyroid_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius));
}
