// Oriented rectangle: A straight stroke with square ends, a rectangle laid from point to point.
// field: exact
// synonyms: oriented box 2d, rotated rectangle, bar, line, stroke
float oriented_rectangle_distance(
    vec2 p,
    vec2 start,       // (-0.5, -0.25) [-100, 100] [-2, 2] m  Middle of the first end.
    vec2 finish,      // (0.5, 0.25) [-100, 100] [-2, 2] m  Middle of the other end.
    float thickness)  // 0.25 [0.001, 100] [0.01, 2] m  Width across.
{
    vec2 along = finish - start;
    float size = length(along);
    vec2 direction = size > 1.0e-6f ? along / max(size, 1.0e-6f) : vec2(1.0f, 0.0f);
    vec2 middle = p - 0.5f * (start + finish);
    vec2 turned = vec2(dot(middle, direction), direction.x * middle.y - direction.y * middle.x);
    vec2 q = abs(turned) - 0.5f * vec2(size, thickness);
    return length(max(q, vec2(0.0f))) + min(max(q.x, q.y), 0.0f);
}

Box oriented_rectangle_bounds(vec2 start, vec2 finish, float thickness)
{
    vec2 centre = 0.5f * (start + finish);
    vec2 reach = 0.5f * abs(finish - start) + vec2(0.5f * thickness);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
