// Component: One of the three numbers of a vector.
// synonyms: split, separate xyz, swizzle, channel
float component_value(
    vec3 vector,  // (0, 0, 0) [-1000000, 1000000] [-10, 10]  The vector.
    int axis)     // x {x, y, z}  Which number to take.
{
    return axis == 0 ? vector.x : (axis == 1 ? vector.y : vector.z);
}
