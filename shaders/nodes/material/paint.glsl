// Paint: Gives everything below it one material.
// field: exact
// synonyms: material, colour, color, assign, surface
// combiner: hard
float paint_distance(float d)
{
    return d;
}

Material paint_material(
    Material material)  // Material of everything below.
{
    return material;
}

Box paint_bounds(Box child)
{
    return child;
}
