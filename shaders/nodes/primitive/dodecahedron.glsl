// Dodecahedron: Twelve equal pentagons.
// field: exact
// synonyms: d12, dice, pentagon solid, twelve-sided
// Mirrors p into the chamber between a corner, the middle of an edge and the middle of a face.
vec3 dodecahedron_fold(vec3 p)
{
    vec3 mirror_normal = vec3(-0.5f, -0.80901699f, 0.30901699f);
    vec3 q = p;
    for (int i = 0; i < 5; i++) {
        q = vec3(abs(q.x), abs(q.y), q.z);
        q = q - mirror_normal * (2.0f * min(dot(mirror_normal, q), 0.0f));
    }
    return vec3(abs(q.x), abs(q.y), q.z);
}

float dodecahedron_distance(
    vec3 p,
    float radius)  // 0.9 [0.001, 100] [0.05, 5] m  Distance from the centre to the twenty corners.
{
    vec3 q = dodecahedron_fold(p);
    float beyond = 0.52573111f * q.x + 0.85065081f * q.z - 0.79465447f * radius;
    vec3 to_edge = vec3(q.x, max(q.y - 0.35682209f * radius, 0.0f), q.z - 0.93417236f * radius);
    return q.x > 0.52573111f * beyond ? beyond : length(to_edge);
}

Box dodecahedron_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius));
}
