// Twist: Winds a solid around the y axis, like a corkscrew.
// field: bound
// synonyms: corkscrew, wring, spiral, screw
vec3 twist_point(
    vec3 p,
    float turn)  // 45.0 [-3600, 3600] [-360, 360] deg/m  Turn per metre of height.
{
    float angle = turn * p.y;
    return vec3(p.x * cos(angle) + p.z * sin(angle), p.y, p.z * cos(angle) - p.x * sin(angle));
}

float twist_reach(Box box)
{
    return length(vec2(abs(box.centre.x) + box.half_size.x, abs(box.centre.z) + box.half_size.z));
}

// Largest singular value of the shear that winding adds at the solid's largest radius. Farther out it does not grow:
// the gradient of a distance turns about the axis with the lever of the solid's own surface.
float twist_stretch(float turn, Box child)
{
    float slope = abs(turn) * twist_reach(child);
    return 0.5f * (slope + sqrt(slope * slope + 4.0f));
}

Box twist_bounds(Box child)
{
    float reach = twist_reach(child);
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(reach, child.half_size.y, reach));
}
