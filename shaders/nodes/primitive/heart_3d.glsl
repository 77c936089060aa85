// Heart 3D: A heart of two half discs on a square corner, thick along z and with round edges.
// field: exact; bound
// synonyms: love, valentine, like
float heart_3d_distance(
    vec3 p,
    float size,      // 1.2 [0.001, 100] [0.05, 5] m  Height of the flat heart before it is rounded.
    float depth,     // 0.3 [0, 200] [0, 5] m  Thickness before it is rounded.
    float rounding)  // 0.08 [0, 50] [0, 1] m  Radius of the edges, added all around.
{
    // Unit heart: the corner at the origin, half discs of radius 0.3536 around (0.25, 0.75) and its mirror image.
    vec2 q = vec2(abs(p.x), p.y + 0.55f * size) / size;
    float to_disc = length(q - vec2(0.25f, 0.75f)) - 0.35355339f;
    float along = 0.5f * max(q.x + q.y, 0.0f);
    vec2 to_edge = q - vec2(along);
    vec2 to_notch = q - vec2(0.0f, 1.0f);
    float below = sqrt(min(dot(to_notch, to_notch), dot(to_edge, to_edge)));
    float outline = q.x + q.y > 1.0f ? to_disc : q.x > q.y ? below : -below;
    float side = outline * size;
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f) - rounding;
}

Box heart_3d_bounds(float size, float depth, float rounding)
{
    vec3 flat_size = vec3(0.60355339f * size, 0.5517767f * size, 0.5f * depth);
    return grow_box(make_box(vec3(0.0f, 0.0017767f * size, 0.0f), flat_size), rounding);
}
