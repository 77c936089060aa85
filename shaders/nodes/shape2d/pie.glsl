// Pie: A slice of a disc that opens upwards.
// field: exact
// synonyms: sector, slice, wedge, pac man, fan
float pie_distance(
    vec2 p,
    float radius,    // 0.6 [0.001, 100] [0.05, 5] m  Radius of the disc.
    float aperture)  // 100.0 [1, 359] deg  Angle of the slice.
{
    vec2 direction = vec2(sin(0.5f * aperture), cos(0.5f * aperture));
    vec2 q = vec2(abs(p.x), p.y);
    float to_arc = length(q) - radius;
    float to_edge = length(q - direction * clamp(dot(q, direction), 0.0f, radius));
    bool within = direction.y * q.x - direction.x * q.y < 0.0f;
    return max(to_arc, within ? -to_edge : to_edge);
}

Box pie_bounds(float radius)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(radius, radius, 0.0f));
}
