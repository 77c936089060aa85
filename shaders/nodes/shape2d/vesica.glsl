// Vesica: A pointed oval, the overlap of two equal discs.
// field: exact
// synonyms: lens, eye, leaf, almond, mandorla
float vesica_distance(
    vec2 p,
    float half_width,   // 0.3 [0.001, 100] [0.05, 5] m  Half the width: 1/50 to 1 of the half height.
    float half_height)  // 0.6 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips.
{
    float bulge = clamp(half_width, 0.02f * half_height, half_height);
    float offset = 0.5f * (half_height * half_height - bulge * bulge) / bulge;
    vec2 q = abs(p);
    float to_tip = length(vec2(q.x, q.y - half_height));
    float to_arc = length(vec2(q.x + offset, q.y)) - (offset + bulge);
    return (q.y - half_height) * offset > q.x * half_height ? to_tip : to_arc;
}

Box vesica_bounds(float half_width, float half_height)
{
    return make_box(vec3(0.0f), vec3(clamp(half_width, 0.02f * half_height, half_height), half_height, 0.0f));
}
