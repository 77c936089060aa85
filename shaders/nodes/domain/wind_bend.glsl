// Wind bend: Pushes a solid sideways, the farther the higher, with its foot held fast: grass or a tree in the wind.
// field: bound
// synonyms: sway, grass, lean, cubic, breeze, blow
vec3 wind_bend_point(
    vec3 p,
    vec2 push,     // (0.6, 0) [-100, 100] [-2, 2] m  How far the top is pushed along x and z.
    float base,    // -0.5 [-1000, 1000] [-5, 5] m  Height of the foot.
    float height)  // 1.5 [0.01, 1000] [0.1, 5] m  Height from the foot to the top.
{
    float share = clamp((p.y - base) / height, 0.0f, 1.0f);
    float cubic = share * share * share;
    return vec3(p.x - push.x * cubic, p.y, p.z - push.y * cubic);
}

// Largest singular value of the shear at the top, where the slope is three times the mean.
float wind_bend_stretch(vec2 push, float height)
{
    float slope = 3.0f * length(push) / height;
    return 0.5f * (slope + sqrt(slope * slope + 4.0f));
}

Box wind_bend_bounds(vec2 push, Box child)
{
    vec3 sideways = 0.5f * vec3(push.x, 0.0f, push.y);
    return make_box(child.centre + sideways, child.half_size + abs(sideways));
}
