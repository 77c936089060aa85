// Cylinder between points: A round column with flat ends from one point to another.
// field: exact
// synonyms: beam, strut, pipe, bar
// Coordinates of p along the line from start and away from it: (away, along, length of the line).
vec3 cylinder_between_place(vec3 p, vec3 start, vec3 finish)
{
    vec3 line = finish - start;
    float size = length(line);
    vec3 axis = size > 1.0e-6f ? line / max(size, 1.0e-6f) : vec3(0.0f, 1.0f, 0.0f);
    float along = dot(p - start, axis);
    return vec3(length(p - start - axis * along), along, size);
}

float cylinder_between_distance(
    vec3 p,
    vec3 start,           // (-0.5, -0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it begins.
    vec3 finish,          // (0.5, 0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it ends.
    float radius)         // 0.3 [0.001, 100] [0.05, 5] m  Distance from the axis to the side.
{
    vec3 place = cylinder_between_place(p, start, finish);
    float side = place.x - radius;
    float cap = abs(place.y - 0.5f * place.z) - 0.5f * place.z;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

Box cylinder_between_bounds(vec3 start, vec3 finish, float radius)
{
    return make_box(0.5f * (start + finish), 0.5f * abs(finish - start) + vec3(radius));
}
