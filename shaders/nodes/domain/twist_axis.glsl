// Twist along axis: Winds a solid around the x, y or z axis, like a corkscrew.
// field: bound
// synonyms: corkscrew, wring, spiral, screw, helix

// The components along the axis and, in order, around it.
vec3 twist_axis_sorted(vec3 v, int axis)
{
    vec3 about_z = vec3(v.z, v.x, v.y);
    return axis == 0 ? v : (axis == 1 ? vec3(v.y, v.z, v.x) : about_z);
}

vec3 twist_axis_restored(vec3 v, int axis)
{
    vec3 about_z = vec3(v.y, v.z, v.x);
    return axis == 0 ? v : (axis == 1 ? vec3(v.z, v.x, v.y) : about_z);
}

vec3 twist_axis_point(
    vec3 p,
    int axis,    // z {x, y, z}  Axis that the solid is wound around.
    float turn)  // 60.0 [-3600, 3600] [-360, 360] deg/m  Turn per metre along the axis.
{
    vec3 v = twist_axis_sorted(p, axis);
    float angle = turn * v.x;
    vec3 wound = vec3(v.x, v.y * cos(angle) - v.z * sin(angle), v.z * cos(angle) + v.y * sin(angle));
    return twist_axis_restored(wound, axis);
}

float twist_axis_reach(Box box, int axis)
{
    vec3 corner = twist_axis_sorted(abs(box.centre) + box.half_size, axis);
    return length(vec2(corner.y, corner.z));
}

// Largest singular value of the shear that winding adds at the solid's largest radius. Farther out it does not grow:
// the gradient of a distance turns about the axis with the lever of the solid's own surface.
float twist_axis_stretch(int axis, float turn, Box child)
{
    float slope = abs(turn) * twist_axis_reach(child, axis);
    return 0.5f * (slope + sqrt(slope * slope + 4.0f));
}

Box twist_axis_bounds(int axis, Box child)
{
    float reach = twist_axis_reach(child, axis);
    vec3 centre = twist_axis_sorted(child.centre, axis);
    vec3 half_size = twist_axis_sorted(child.half_size, axis);
    return make_box(twist_axis_restored(vec3(centre.x, 0.0f, 0.0f), axis),
                    twist_axis_restored(vec3(half_size.x, reach, reach), axis));
}
