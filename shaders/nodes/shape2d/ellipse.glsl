// Ellipse: A circle with a radius of its own along x and y.
// field: bound
// synonyms: oval, stretched circle
float ellipse_distance(
    vec2 p,
    vec2 radii)  // (0.6, 0.35) [0.001, 100] [0.05, 5] m  Radius along x and y.
{
    // Both the scaled disc and the rectangle around it never overshoot; the larger of the two does not either.
    float disc = (length(p / radii) - 1.0f) * min(radii.x, radii.y);
    vec2 q = abs(p) - radii;
    float around = length(max(q, vec2(0.0f))) + min(max(q.x, q.y), 0.0f);
    return max(disc, around);
}

Box ellipse_bounds(vec2 radii)
{
    return make_box(vec3(0.0f), vec3(radii.x, radii.y, 0.0f));
}
