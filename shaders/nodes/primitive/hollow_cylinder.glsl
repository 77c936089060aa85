// Hollow cylinder: A pipe along the y axis with flat ends.
// field: exact
// synonyms: pipe, tube, washer, sleeve
float hollow_cylinder_distance(
    vec3 p,
    float outer_radius,  // 0.6 [0.001, 100] [0.05, 5] m  Distance from the axis to the outside.
    float inner_radius,  // 0.4 [0, 100] [0, 5] m  Distance from the axis to the inside, less than the outer one.
    float height)        // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end.
{
    float bore = min(inner_radius, 0.99f * outer_radius);
    float away = length(vec2(p.x, p.z));
    float side = abs(away - 0.5f * (outer_radius + bore)) - 0.5f * (outer_radius - bore);
    side = bore > 0.0f ? side : away - outer_radius;
    float cap = abs(p.y) - 0.5f * height;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box hollow_cylinder_bounds(float outer_radius, float height)
{
    return make_box(vec3(0.0f), vec3(outer_radius, 0.5f * height, outer_radius));
}
