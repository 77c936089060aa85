// Parallelogram: A slanted rectangle.
// field: exact
// synonyms: skewed rectangle, rhomboid, slanted box
float parallelogram_distance(
    vec2 p,
    float half_width,   // 0.4 [0.001, 100] [0.05, 5] m  Half the length of the bottom and the top.
    float half_height,  // 0.3 [0.001, 100] [0.05, 5] m  Half the height.
    float skew)         // 0.2 [-100, 100] [-2, 2] m  How far the top lies to the right of the centre.
{
    vec2 q = p.y < 0.0f ? -p : p;
    vec2 side = vec2(skew, half_height);
    float beyond = q.y - half_height;
    float across = q.x - skew;
    vec2 from_top = vec2(across - clamp(across, -half_width, half_width), beyond);
    float lean = q.x * side.y - q.y * side.x;
    vec2 r = lean < 0.0f ? -q : q;
    r = vec2(r.x - half_width, r.y);
    vec2 from_side = r - side * clamp(dot(r, side) / dot(side, side), -1.0f, 1.0f);
    float outline = sqrt(min(dot(from_top, from_top), dot(from_side, from_side)));
    return beyond < 0.0f && abs(lean) < half_width * half_height ? -outline : outline;
}

Box parallelogram_bounds(float half_width, float half_height, float skew)
{
    return make_box(vec3(0.0f, 0.0f, 0.0f), vec3(half_width + abs(skew), half_height, 0.0f));
}
