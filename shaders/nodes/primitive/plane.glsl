// Plane: Everything below an endless plane, such as a floor.
// field: exact
// synonyms: floor, ground, half space, wall
float plane_distance(
    vec3 p,
    vec3 normal,   // (0, 1, 0) [-1, 1]  Direction that the plane faces; its length does not matter.
    float height)  // 0.0 [-1000, 1000] [-5, 5] m  Distance from the origin to the plane along the normal.
{
    float size = length(normal);
    vec3 facing = size > 1.0e-6f ? normal / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    return dot(p, facing) - height;
}

Box plane_bounds()
{
    return everywhere();
}
