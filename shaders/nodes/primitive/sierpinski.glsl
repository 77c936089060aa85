// Sierpinski tetrahedron: A tetrahedron of four smaller ones, each again of four, and so on.
// field: exact; bound
// synonyms: fractal, sierpinski gasket, triangle fractal, tetrix
// Distance to the tetrahedron whose corners have coordinates of 1 and -1 and an even count of -1, mirrored into the
// chamber x >= y >= |z|: there the nearest face is x + y - z = 1 and the nearest edge (1, t, t).
float sierpinski_solid(vec3 q)
{
    float beyond = (q.x + q.y - q.z - 1.0f) * 0.57735027f;
    float along = clamp(0.5f * (q.y + q.z), -1.0f, 1.0f);
    float to_edge = length(vec3(q.x - 1.0f, q.y - along, q.z - along));
    return q.y - q.z > 2.0f * (q.x - 1.0f) ? beyond : to_edge;
}

vec3 sierpinski_fold(vec3 p)
{
    vec3 q = abs(p);
    float most = max(q.x, max(q.y, q.z));
    float least = min(q.x, min(q.y, q.z));
    float between = max(min(q.x, q.y), min(max(q.x, q.y), q.z));
    bool turned = (p.x < 0.0f) != ((p.y < 0.0f) != (p.z < 0.0f));
    return vec3(most, between, turned ? -least : least);
}

// Turns the corner (1, 1, 1) upwards.
vec3 sierpinski_upright(vec3 p)
{
    vec3 up = vec3(0.57735027f, 0.57735027f, 0.57735027f);
    vec3 right = vec3(0.70710678f, -0.70710678f, 0.0f);
    vec3 ahead = vec3(-0.40824829f, -0.40824829f, 0.81649658f);
    return p.x * right + p.y * up + p.z * ahead;
}

float sierpinski_distance(
    vec3 p,
    float radius,  // 1.0 [0.001, 100] [0.05, 5] m  Distance from the centre to the four corners.
    int levels)    // 4 [0, 10] [0, 8]  How often each tetrahedron is divided.
{
    float scale = 0.57735027f * radius;
    vec3 q = sierpinski_fold(sierpinski_upright(p / scale));
    for (int i = 0; i < 10; i++) {
        if (i >= levels) {
            break;
        }
        q = sierpinski_fold(2.0f * q - vec3(1.0f));
        scale = 0.5f * scale;
    }
    return sierpinski_solid(q) * scale;
}

Box sierpinski_bounds(float radius)
{
    return make_box(vec3(0.0f, 0.33333333f * radius, 0.0f), vec3(0.94280904f, 0.66666667f, 0.94280904f) * radius);
}
