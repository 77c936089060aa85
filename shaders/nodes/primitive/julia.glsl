// Julia: A fractal of swirling shells: quaternions whose squares, with a constant added again and again, stay near.
// The fourth coordinate is the same everywhere, so that a slice of the whole shows.
// field: approximate 0.5
// synonyms: fractal, quaternion, julia set, swirl
float julia_distance(
    vec3 p,
    float size,      // 0.7 [0.001, 100] [0.05, 5] m  Length of one unit of the quaternions; the whole is 2 to 3 units wide.
    vec3 constant,   // (-0.2, 0.6, 0.2) [-1, 1]  First three parts of the constant.
    float fourth,    // 0.2 [-1, 1]  Fourth part of the constant.
    float slice,     // 0.0 [-1, 1]  Fourth coordinate of all points.
    int iterations)  // 6 [1, 12]  How many squares are taken: more show finer shells.
{
    vec4 added = vec4(constant, fourth);
    vec4 z = vec4(p / size, slice);
    float r = length(z);
    float slope = 1.0f;
    for (int i = 0; i < 12; i++) {
        bool going = i < iterations && r < 4.0f;
        vec4 square = vec4(z.x * z.x - z.y * z.y - z.z * z.z - z.w * z.w, 2.0f * z.x * z.y, 2.0f * z.x * z.z,
                           2.0f * z.x * z.w);
        slope = going ? 2.0f * max(r, 1.0e-6f) * slope : slope;
        z = going ? square + added : z;
        r = going ? length(z) : r;
    }
    // The surface is where the last square is 2 from the origin: smooth, so that its normals are.
    // What is farther than this from the origin leaves it at once.
    float reach = 0.5f + sqrt(0.25f + length(added));
    float ball = length(p) / size - reach;
    float estimate = 0.5f * log(max(0.5f * r, 1.0e-6f)) * r / slope;
    return size * (ball > 0.75f ? ball : max(ball, estimate));
}

Box julia_bounds(float size, vec3 constant, float fourth)
{
    return make_box(vec3(0.0f), vec3(size * (0.5f + sqrt(0.25f + length(vec4(constant, fourth))))));
}
