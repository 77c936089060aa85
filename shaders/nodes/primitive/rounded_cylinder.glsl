// Rounded cylinder: A round column along the y axis whose rims are rounded off within its size.
// field: exact
// synonyms: soft cylinder, puck, pebble
float rounded_cylinder_distance(
    vec3 p,
    float radius,    // 0.5 [0.001, 100] [0.05, 5] m  Distance from the axis to the side, rounding included.
    float height,    // 1.0 [0.001, 200] [0.05, 5] m  Length from end to end, rounding included.
    float rounding)  // 0.1 [0, 50] [0, 1] m  Radius of the rims, at most the radius and half the height.
{
    float rim = min(rounding, min(radius, 0.5f * height));
    float side = length(vec2(p.x, p.z)) - (radius - rim);
    float cap = abs(p.y) - (0.5f * height - rim);
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f) - rim;
}

Box rounded_cylinder_bounds(float radius, float height)
{
    return make_box(vec3(0.0f), vec3(radius, 0.5f * height, radius));
}
