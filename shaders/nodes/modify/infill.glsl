// Infill: Fills a solid with a gyroid, a winding wall that splits space into two mazes.
// field: bound
// synonyms: gyroid, lattice, sponge, porous, foam, 3d printing
// combiner: hard
const float INFILL_TWO_PI = 6.28318531f;

// The gyroid's slope never exceeds the square root of six, in turns of its period.
float infill_distance(
    vec3 p,
    float d,
    float period,     // 0.5 [0.01, 100] [0.1, 5] m  Distance after which the mazes repeat.
    float thickness)  // 0.05 [0.001, 10] [0.01, 0.5] m  Thickness of the wall at least; where it bends it is thicker.
{
    float turns = INFILL_TWO_PI / period;
    vec3 q = p * turns;
    float gyroid = sin(q.x) * cos(q.y) + sin(q.y) * cos(q.z) + sin(q.z) * cos(q.x);
    return max(d, abs(gyroid) / (2.4494898f * turns) - 0.5f * thickness);
}

Box infill_bounds(Box child)
{
    return child;
}
