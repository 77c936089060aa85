// Shear: Slants a solid: the higher, the farther it moves sideways.
// field: bound
// point: affine
// synonyms: skew, slant, lean, italic, tilt
vec3 shear_point(
    vec3 p,
    vec2 slope)  // (0.5, 0) [-100, 100] [-2, 2]  How far it moves along x and z per metre of height.
{
    return vec3(p.x - slope.x * p.y, p.y, p.z - slope.y * p.y);
}

// Largest singular value of the shear.
float shear_stretch(vec2 slope)
{
    float steep = length(slope);
    return 0.5f * (steep + sqrt(steep * steep + 4.0f));
}

Box shear_bounds(vec2 slope, Box child)
{
    vec3 sideways = vec3(slope.x, 0.0f, slope.y);
    return make_box(child.centre + sideways * child.centre.y,
                    child.half_size + abs(sideways) * child.half_size.y);
}
