// Endless cone: A cone that opens downwards from its tip without end.
// field: exact
// synonyms: infinite cone, unbounded cone, spotlight
float cone_unbounded_distance(
    vec3 p,
    float angle)  // 30.0 [1, 89] deg  Angle between the axis and the side.
{
    vec2 q = vec2(length(vec2(p.x, p.z)), -p.y);
    vec2 side = vec2(sin(angle), cos(angle));
    float away = length(q - side * max(dot(q, side), 0.0f));
    return q.x * side.y < q.y * side.x ? -away : away;
}

Box cone_unbounded_bounds()
{
    return everywhere();
}
