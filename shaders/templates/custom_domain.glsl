// Custom domain: leans what it reads, yours to change.
// field: approximate 0.6
vec3 custom_domain_point(
    vec3 p,
    float lean)  // 0.4 [-1, 1]  How far it leans to the right for each metre of height.
{
    return vec3(p.x - lean * p.y, p.y, p.z);
}

// A box around the surface; child is the one of the input.
Box custom_domain_bounds(float lean, Box child)
{
    vec3 centre = child.centre + vec3(lean * child.centre.y, 0.0f, 0.0f);
    return make_box(centre, child.half_size + vec3(abs(lean) * child.half_size.y, 0.0f, 0.0f));
}
