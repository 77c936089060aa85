// Project: Looks at a solid along z and gives its outline as a flat shape.
// The solid is seen through 24 slices; what lies between two of them, or beyond the first and last, is left out.
// field: bound
// synonyms: shadow, silhouette, outline, flatten, footprint, 3d to 2d
// copies: 24
vec3 project_point(
    vec2 p,
    float depth,  // 2.0 [0.01, 1000] [0.1, 10] m  Length along z that is looked through, half of it behind the plane.
    int copy)
{
    return vec3(p.x, p.y, depth * ((float(copy) + 0.5f) / 24.0f - 0.5f));
}

float project_distance(float acc, float d)
{
    return min(acc, d);
}

Box project_bounds(Box child)
{
    return make_box(vec3(child.centre.x, child.centre.y, 0.0f), vec3(child.half_size.x, child.half_size.y, 0.0f));
}
