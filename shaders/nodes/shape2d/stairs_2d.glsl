// Stairs 2D: A flight of steps that rises to the right, seen from the side.
// field: exact
// synonyms: steps, staircase, zigzag
float stairs_2d_distance(
    vec2 p,
    vec2 tread,  // (0.25, 0.2) [0.001, 10] [0.05, 2] m  Depth and height of one step.
    int steps)   // 4 [1, 32] [1, 12]  Number of steps.
{
    vec2 whole = tread * float(steps);
    vec2 q = p + 0.5f * whole;
    vec2 from_floor = vec2(q.x - clamp(q.x, 0.0f, whole.x), q.y);
    vec2 from_back = vec2(q.x - whole.x, q.y - clamp(q.y, 0.0f, whole.y));
    float squared = min(dot(from_floor, from_floor), dot(from_back, from_back));
    for (int i = 0; i < 32; i++) {
        if (i >= steps) {
            break;
        }
        float near_x = q.x - tread.x * float(i);
        float near_y = q.y - tread.y * float(i);
        vec2 from_riser = vec2(near_x, near_y - clamp(near_y, 0.0f, tread.y));
        vec2 from_tread = vec2(near_x - clamp(near_x, 0.0f, tread.x), near_y - tread.y);
        squared = min(squared, min(dot(from_riser, from_riser), dot(from_tread, from_tread)));
    }
    float top = tread.y * (floor(q.x / tread.x) + 1.0f);
    bool inside = q.x > 0.0f && q.x < whole.x && q.y > 0.0f && q.y < top;
    return inside ? -sqrt(squared) : sqrt(squared);
}

Box stairs_2d_bounds(vec2 tread, int steps)
{
    vec2 reach = 0.5f * tread * float(steps);
    return make_box(vec3(0.0f), vec3(reach.x, reach.y, 0.0f));
}
