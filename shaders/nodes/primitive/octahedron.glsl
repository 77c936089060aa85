// Octahedron: Two square pyramids base to base, with eight equal faces.
// field: exact
// synonyms: diamond, bipyramid, d8
float octahedron_distance(
    vec3 p,
    float radius)  // 1.0 [0.001, 100] [0.05, 5] m  Distance from the centre to the six corners.
{
    vec3 q = abs(p);
    float most = max(q.x, max(q.y, q.z));
    float least = min(q.x, min(q.y, q.z));
    float between = max(min(q.x, q.y), min(max(q.x, q.y), q.z));
    float beyond = most + between + least - radius;
    // Where the foot on the face's plane leaves the face, the nearest point lies on the edge of the two larger axes.
    float on_edge = clamp(0.5f * (radius + most - between), 0.0f, radius);
    float to_edge = length(vec3(most - on_edge, between - (radius - on_edge), least));
    return 3.0f * least < beyond ? to_edge : beyond * 0.57735027f;
}

Box octahedron_bounds(float radius)
{
    return make_box(vec3(0.0f), vec3(radius));
}
