// Solid angle: The part of a ball inside a cone around the y axis, such as an ice cream cone.
// field: exact
// synonyms: ball sector, spherical sector, ice cream, pac-man
float solid_angle_distance(
    vec3 p,
    float radius,  // 1.0 [0.001, 100] [0.05, 5] m  Radius of the ball.
    float angle)   // 40.0 [1, 179] deg  Angle between the axis and the side.
{
    vec2 side = vec2(sin(angle), cos(angle));
    vec2 q = vec2(length(vec2(p.x, p.z)), p.y);
    float beyond = length(q) - radius;
    float to_side = length(q - side * clamp(dot(q, side), 0.0f, radius));
    return max(beyond, q.x * side.y < q.y * side.x ? -to_side : to_side);
}

Box solid_angle_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius));
}
