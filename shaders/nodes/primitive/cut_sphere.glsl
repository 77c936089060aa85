// Cut sphere: A ball of which a flat cut leaves the upper part, such as a dome.
// field: exact
// synonyms: dome, half ball, hemisphere, spherical cap
float cut_sphere_distance(
    vec3 p,
    float radius,  // 0.8 [0.001, 100] [0.05, 5] m  Radius of the ball.
    float cut)     // -0.2 [-100, 100] [-2, 2] m  Height of the cut above the centre, less than the radius.
{
    float level = clamp(cut, -0.99f * radius, 0.99f * radius);
    float rim = sqrt(radius * radius - level * level);
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float to_rim = length(q - vec2(rim, level));
    float beyond = length(q) - radius;
    float to_arc = q.x * level <= q.y * rim ? abs(beyond) : to_rim;
    float to_cut = q.x < rim ? abs(q.y - level) : to_rim;
    float nearest = min(to_arc, to_cut);
    return beyond < 0.0f && q.y > level ? -nearest : nearest;
}

Box cut_sphere_bounds(float radius, float cut)
{
    float level = clamp(cut, -0.99f * radius, 0.99f * radius);
    float reach = level < 0.0f ? radius : sqrt(radius * radius - level * level);
    return make_box(vec3(0.0f, 0.5f * (radius + level), 0.0f), vec3(reach, 0.5f * (radius - level), reach));
}
