// Rounded union: Both shapes together, with a fillet of a true radius where they meet at right angles.
// field: bound
// synonyms: fillet union, round union, union round, weld
float rounded_union_distance(
    float a,
    float b,
    float radius)  // 0.3 [0, 10] [0, 1] m  Radius of the fillet.
{
    vec2 within = max(vec2(radius - a, radius - b), vec2(0.0f));
    return max(radius, min(a, b)) - length(within);
}

// Where both surfaces face the same way, both distances change at once.
float rounded_union_lipschitz()
{
    return 1.41421357f;
}

float rounded_union_blend(float a, float b, float radius)
{
    float size = max(radius, 1.0e-6f);
    float share = 0.5f * max(size - abs(a - b), 0.0f) / size;
    return b < a ? 1.0f - share : share;
}

bool rounded_union_shows_b(float a, float b)
{
    return b <= a;
}

Box rounded_union_bounds(Box box_a, Box box_b, float radius)
{
    return grow_box(join_boxes(box_a, box_b), 0.3f * radius);
}
