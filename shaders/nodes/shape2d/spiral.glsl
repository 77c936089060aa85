// Spiral: A stroke that winds outwards in half circles, with round ends.
// field: exact; bound
// synonyms: coil, swirl, snail, helix 2d, volute
float spiral_distance(
    vec2 p,
    int turns,            // 3 [1, 32] [1, 12]  Number of turns.
    float inner_radius,   // 0.08 [0, 100] [0, 5] m  Radius where the stroke begins.
    float spacing,        // 0.18 [0.001, 100] [0.02, 2] m  Distance from turn to turn.
    float thickness)      // 0.08 [0.001, 100] [0.01, 2] m  Width of the stroke.
{
    // Above the x axis the half circles lie around the origin, below it half a spacing to the right.
    bool above = p.y > 0.0f;
    float from_centre = length(vec2(above ? p.x : p.x - 0.5f * spacing, p.y));
    float first = above ? inner_radius : inner_radius + 0.5f * spacing;
    float number = clamp(floor((from_centre - first) / spacing + 0.5f), 0.0f, float(turns - 1));
    float to_turn = abs(from_centre - first - number * spacing);
    float to_start = length(vec2(p.x - inner_radius, p.y));
    float to_finish = length(vec2(p.x - inner_radius - float(turns) * spacing, p.y));
    return min(to_turn, min(to_start, to_finish)) - 0.5f * thickness;
}

Box spiral_bounds(int turns, float inner_radius, float spacing, float thickness)
{
    float reach = inner_radius + float(turns) * spacing;
    float half_width = reach - 0.5f * spacing;
    return make_box(vec3(0.5f * spacing, 0.0f, 0.0f),
                    vec3(half_width + 0.5f * thickness, half_width + 0.5f * thickness, 0.0f));
}
