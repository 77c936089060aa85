// Lens 3D: The overlap of two equal balls, round and thin at its rim.
// field: exact
// synonyms: magnifier, lentil, discus, flying saucer
float lens_3d_distance(
    vec3 p,
    float radius,     // 0.8 [0.001, 100] [0.05, 5] m  Distance from the axis to the rim.
    float thickness)  // 0.5 [0.001, 100] [0.05, 5] m  Thickness in the middle: 1/50 to 1 of the width.
{
    float bulge = clamp(0.5f * thickness, 0.02f * radius, radius);
    float offset = 0.5f * (radius * radius - bulge * bulge) / bulge;
    vec2 q = vec2(length(vec2(p.x, p.z)), abs(p.y));
    float to_rim = length(vec2(q.x - radius, q.y));
    float to_cap = length(vec2(q.x, q.y + offset)) - (offset + bulge);
    return (q.x - radius) * offset > q.y * radius ? to_rim : to_cap;
}

Box lens_3d_bounds(float radius, float thickness)
{
    return make_box(vec3(0.0f), vec3(radius, clamp(0.5f * thickness, 0.02f * radius, radius), radius));
}
