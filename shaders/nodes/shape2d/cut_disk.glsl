// Cut disk: The part of a disc above a straight cut.
// field: exact
// synonyms: circle segment, half disc, dome, cap 2d, semicircle
float cut_disk_height(float radius, float cut)
{
    return clamp(cut, -0.98f * radius, 0.98f * radius);
}

float cut_disk_distance(
    vec2 p,
    float radius,  // 0.6 [0.001, 100] [0.05, 5] m  Radius of the disc.
    float cut)     // -0.15 [-100, 100] [-5, 5] m  Height of the cut above the centre of the disc.
{
    float height = cut_disk_height(radius, cut);
    float half_width = sqrt(radius * radius - height * height);
    vec2 q = vec2(abs(p.x), p.y);
    float to_arc = length(q) - radius;
    float to_cut = height - q.y;
    float to_corner = length(vec2(q.x - half_width, q.y - height));
    // Beyond the ray from the centre through the corner, the corner is nearer than the arc.
    bool beyond = height * q.x > half_width * q.y;
    float around = q.x < half_width && q.y < height ? to_cut : (beyond ? to_corner : to_arc);
    float within = max(to_arc, to_cut);
    return within < 0.0f ? within : around;
}

Box cut_disk_bounds(float radius, float cut)
{
    float height = cut_disk_height(radius, cut);
    float half_width = height < 0.0f ? radius : sqrt(radius * radius - height * height);
    return make_box(vec3(0.0f, 0.5f * (radius + height), 0.0f), vec3(half_width, 0.5f * (radius - height), 0.0f));
}
