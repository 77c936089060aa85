// Capsule between points: A round rod with half balls at its ends from one point to another.
// field: exact
// synonyms: line segment, bone, stick, rod between
float capsule_between_distance(
    vec3 p,
    vec3 start,           // (-0.5, -0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it begins.
    vec3 finish,          // (0.5, 0.5, 0.0) [-1000, 1000] [-5, 5] m  Where it ends.
    float radius)         // 0.25 [0.001, 100] [0.05, 5] m  Radius of the rod and of its ends.
{
    vec3 line = finish - start;
    float share = clamp(dot(p - start, line) / max(dot(line, line), 1.0e-12f), 0.0f, 1.0f);
    return length(p - start - line * share) - radius;
}

Box capsule_between_bounds(vec3 start, vec3 finish, float radius)
{
    return make_box(0.5f * (start + finish), 0.5f * abs(finish - start) + vec3(radius));
}
