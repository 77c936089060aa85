// Squircle: Between a circle and a square.
// field: bound
// synonyms: rounded square, app icon, soft square, superellipse
float squircle_distance(
    vec2 p,
    float radius,       // 0.5 [0.001, 100] [0.05, 5] m  Distance from the centre to the middle of a side.
    float squareness)   // 0.6 [0, 1]  0 is a circle, 1 a square.
{
    vec2 q = abs(p);
    // Lengths are mixed, not their squares: so the field grows no faster than the distance, however far away.
    return mix(length(q), max(q.x, q.y), squareness) - radius;
}

Box squircle_bounds(float radius)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(radius, radius, 0.0f));
}
