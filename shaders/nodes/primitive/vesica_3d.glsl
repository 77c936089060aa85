// Vesica 3D: A spindle along the y axis, pointed at both ends.
// field: exact
// synonyms: spindle, almond, lemon, american football, seed
float vesica_3d_distance(
    vec3 p,
    float half_width,   // 0.4 [0.001, 100] [0.05, 5] m  Half the width: 1/50 to 1 of the half height.
    float half_height)  // 0.9 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips.
{
    float bulge = clamp(half_width, 0.02f * half_height, half_height);
    float offset = 0.5f * (half_height * half_height - bulge * bulge) / bulge;
    vec2 q = vec2(length(vec2(p.x, p.z)), abs(p.y));
    float to_tip = length(vec2(q.x, q.y - half_height));
    float to_arc = length(vec2(q.x + offset, q.y)) - (offset + bulge);
    return (q.y - half_height) * offset > q.x * half_height ? to_tip : to_arc;
}

Box vesica_3d_bounds(float half_width, float half_height)
{
    float reach = clamp(half_width, 0.02f * half_height, half_height);
    return make_box(vec3(0.0f), vec3(reach, half_height, reach));
}
