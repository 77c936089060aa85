// Rounded cross: A four-pointed star with hollow round sides.
// field: exact
// synonyms: astroid, four pointed star, sparkle, shuriken
float rounded_cross_distance(
    vec2 p,
    float half_width,   // 0.6 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips left and right.
    float half_height)  // 0.5 [0.001, 100] [0.05, 5] m  The same up and down: 1/20 to 1 of the half width.
{
    float height = clamp(half_height, 0.05f * half_width, half_width) / half_width;
    float bow = 0.5f * (height + 1.0f / height);
    vec2 q = abs(p) / half_width;
    vec2 from_top = vec2(q.x, q.y - height);
    vec2 from_side = vec2(q.x - 1.0f, q.y);
    float to_tips = sqrt(min(dot(from_top, from_top), dot(from_side, from_side)));
    float to_bow = bow - length(vec2(q.x - 1.0f, q.y - bow));
    bool at_bow = q.x < 1.0f && q.y < q.x * (bow - height) + height;
    return half_width * (at_bow ? to_bow : to_tips);
}

Box rounded_cross_bounds(float half_width, float half_height)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_width, clamp(half_height, 0.05f * half_width, half_width), 0.0f));
}
