// Drop: A round drop with a pointed tip on top.
// field: exact
// synonyms: teardrop, water drop, tear, map pin
float drop_length(float radius, float height)
{
    return max(height, 1.02f * radius);
}

float drop_distance(
    vec2 p,
    float radius,  // 0.35 [0.001, 100] [0.05, 5] m  Radius of the round part.
    float height)  // 0.75 [0.001, 200] [0.05, 5] m  Distance from the centre of the round part to the tip.
{
    float reach = drop_length(radius, height);
    vec2 q = vec2(abs(p.x), p.y + 0.5f * (reach - radius));
    float sine = radius / reach;
    float cosine = sqrt(1.0f - sine * sine);
    float along = q.y * cosine - q.x * sine;
    float to_side = q.x * cosine + q.y * sine - radius;
    float to_tip = length(vec2(q.x, q.y - reach));
    return along < 0.0f ? length(q) - radius : (along > cosine * reach ? to_tip : to_side);
}

Box drop_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * (drop_length(radius, height) + radius), 0.0f));
}
