// Arc: A curved stroke along a circle, open at the bottom, with round ends.
// field: exact; bound
// synonyms: curved stroke, open ring, rainbow, smile
float arc_distance(
    vec2 p,
    float radius,     // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of the stroke.
    float aperture,   // 240.0 [0, 360] deg  Angle from end to end.
    float thickness)  // 0.18 [0.001, 100] [0.01, 2] m  Width of the stroke.
{
    vec2 direction = vec2(sin(0.5f * aperture), cos(0.5f * aperture));
    vec2 q = vec2(abs(p.x), p.y);
    float to_end = length(q - direction * radius);
    float to_arc = abs(length(q) - radius);
    return (direction.y * q.x > direction.x * q.y ? to_end : to_arc) - 0.5f * thickness;
}

Box arc_bounds(float radius, float thickness)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(radius + 0.5f * thickness, radius + 0.5f * thickness, 0.0f));
}
