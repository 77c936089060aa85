// Output: The root of the scene: what is drawn, through which camera, under which sky.
// field: exact
// synonyms: result, scene, root, render
// combiner: hard
float output_distance(float d, Camera camera, Sky sky)
{
    return d;
}

Box output_bounds(Box child)
{
    return child;
}
