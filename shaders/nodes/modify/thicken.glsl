// Thicken along axis: Moves the surface outwards by an amount that changes from one end to the other.
// field: bound
// synonyms: grow, swell, club, flare, gradient, offset along
float thicken_distance(
    vec3 p,
    float d,
    int axis,      // y {x, y, z}  Axis along which the amount changes.
    float first,   // 0.0 [-100, 100] [-1, 1] m  How far the surface moves before the change.
    float second,  // 0.3 [-100, 100] [-1, 1] m  How far it moves after the change.
    float start,   // -0.5 [-1000, 1000] [-5, 5] m  Where on the axis the change begins.
    float span)    // 1.0 [0.01, 1000] [0.1, 5] m  Length of the change.
{
    float place = axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
    return d - mix(first, second, clamp((place - start) / span, 0.0f, 1.0f));
}

float thicken_lipschitz(float first, float second, float span)
{
    return 1.0f + abs(second - first) / span;
}

Box thicken_bounds(float first, float second, Box child)
{
    return grow_box(child, max(first, second));
}
