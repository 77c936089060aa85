// Circle: A disc around the origin.
// field: exact
// synonyms: disc, disk, round
float circle_distance(
    vec2 p,
    float radius)  // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the outline.
{
    return length(p) - radius;
}

Box circle_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius, radius, 0.0f));
}
