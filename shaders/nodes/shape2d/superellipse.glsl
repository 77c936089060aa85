// Superellipse: An ellipse whose corners swell or shrink, from a diamond over an ellipse to a rectangle.
// field: bound
// synonyms: lame curve, squircle, hyperellipse, rounded rectangle
float superellipse_distance(
    vec2 p,
    vec2 radii,      // (0.6, 0.4) [0.001, 100] [0.05, 5] m  Radius along x and y.
    float exponent)  // 3.5 [1, 10]  1 is a diamond, 2 an ellipse, more comes near a rectangle.
{
    vec2 q = abs(p) / radii;
    float larger = max(q.x, q.y);
    float ratio = min(q.x, q.y) / max(larger, 1.0e-20f);
    // The larger part stands before the root, so that no power overflows.
    float swell = pow(1.0f + pow(max(ratio, 1.0e-12f), exponent), 1.0f / exponent);
    vec2 beyond = abs(p) - radii;
    float around = length(max(beyond, vec2(0.0f))) + min(max(beyond.x, beyond.y), 0.0f);
    return max((larger * swell - 1.0f) * min(radii.x, radii.y), around);
}

// Below an ellipse the diamond's corners pull in; the slope is that of the sum of powers on the diagonal.
float superellipse_lipschitz(float exponent)
{
    return exponent < 2.0f ? exp2(1.0f / exponent - 0.5f) : 1.0f;
}

Box superellipse_bounds(vec2 radii)
{
    return make_box(vec3(0.0f), vec3(radii.x, radii.y, 0.0f));
}
