// Extrude: Pulls a flat shape out along z, with flat ends.
// field: exact
// synonyms: prism, push pull, thicken, solidify, 2d to 3d
vec2 extrude_point(vec3 p)
{
    return vec2(p.x, p.y);
}

float extrude_distance(
    vec3 p,
    float d,
    float depth)  // 0.5 [0.001, 200] [0.01, 5] m  Length from end to end; the shape lies in the middle.
{
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(d, 0.0f), max(cap, 0.0f))) + min(max(d, cap), 0.0f);
}

Box extrude_bounds(float depth, Box child)
{
    return make_box(vec3(child.centre.x, child.centre.y, 0.0f),
                    vec3(child.half_size.x, child.half_size.y, 0.5f * depth));
}
