// Implicit surface: Where a formula of x, y and z that you type is below 0, in a box.
// field: bound
// synonyms: formula, equation, algebraic surface, level set, isosurface, function, quadric, quartic, tangle cube
// number k: 0.47 [-100, 100] [0, 1]  A number of the formula.
float implicit_distance(
    vec3 p,
    float steepest,
    float formula,   // formula "x^4 - x^2 + y^4 - y^2 + z^4 - z^2 + k" over half_size  The surface is where this is 0.
    vec3 half_size)  // (1.05, 1.05, 1.05) [0.001, 100] [0.1, 5] m  Half the size of the box in which the surface is looked for.
{
    float inside = formula / steepest;
    vec3 q = abs(p) - half_size;
    float outside = length(max(q, vec3(0.0f)));
    float nearest_side = min(max(q.x, max(q.y, q.z)), 0.0f);
    // The formula is that of the nearest point of the box: from outside, the way there stands upright on the rest.
    return outside > 0.0f ? length(vec2(outside, max(inside, 0.0f))) : max(inside, nearest_side);
}

Box implicit_bounds(vec3 half_size)
{
    return make_box(vec3(0.0f), half_size);
}
