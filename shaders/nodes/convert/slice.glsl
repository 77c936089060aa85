// Slice: Cuts a solid with a plane across z and gives the cut as a flat shape.
// field: bound
// synonyms: cross section, cut, section, 3d to 2d
vec3 slice_point(
    vec2 p,
    float height)  // 0.0 [-1000, 1000] [-5, 5] m  Where along z the cut lies.
{
    return vec3(p.x, p.y, height);
}

Box slice_bounds(Box child)
{
    return make_box(vec3(child.centre.x, child.centre.y, 0.0f), vec3(child.half_size.x, child.half_size.y, 0.0f));
}
