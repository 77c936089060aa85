// Cut hollow sphere: A thin bowl, the part of a hollow ball below a cut.
// field: exact; bound
// synonyms: bowl, cup, shell of a ball, dish
float cut_hollow_sphere_distance(
    vec3 p,
    float radius,     // 0.8 [0.001, 100] [0.05, 5] m  Radius of the ball, to the middle of the wall.
    float cut,        // 0.2 [-100, 100] [-2, 2] m  Height of the rim above the centre, less than the radius.
    float thickness)  // 0.1 [0.001, 50] [0.01, 0.5] m  Thickness of the wall.
{
    float level = clamp(cut, -0.99f * radius, 0.99f * radius);
    float rim = sqrt(radius * radius - level * level);
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float to_wall = q.y * rim <= q.x * level ? abs(length(q) - radius) : length(q - vec2(rim, level));
    return to_wall - 0.5f * thickness;
}

Box cut_hollow_sphere_bounds(float radius, float cut, float thickness)
{
    float level = clamp(cut, -0.99f * radius, 0.99f * radius);
    float reach = level > 0.0f ? radius : sqrt(radius * radius - level * level);
    Box wall = make_box(vec3(0.0f, 0.5f * (level - radius), 0.0f), vec3(reach, 0.5f * (level + radius), reach));
    return grow_box(wall, 0.5f * thickness);
}
