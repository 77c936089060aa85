// Polar repeat: Copies of a solid in a circle around the y axis.
// Exact for solids that leave their sector by up to half a sector.
// field: exact; bound
// synonyms: circular array, radial, ring, revolve copies, clock
// copies: 3
// combiner: hard
const float POLAR_REPEAT_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float polar_repeat_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * POLAR_REPEAT_PI - angle : angle;
    angle = x < 0.0f ? POLAR_REPEAT_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// The sector that holds p, and those before and after it.
float polar_repeat_index(vec3 p, int count, int copy)
{
    float sectors = polar_repeat_angle(p.x, p.z) * float(count) / (2.0f * POLAR_REPEAT_PI);
    return floor(sectors + 0.5f) + float(copy - 1);
}

vec3 polar_repeat_cell(
    vec3 p,
    int count,  // 6 [1, 256] [2, 24]  Number of copies.
    int copy)
{
    float index = polar_repeat_index(p, count, copy);
    return vec3(index - float(count) * floor((index + 0.5f) / float(count)), 0.0f, 0.0f);
}

vec3 polar_repeat_point(
    vec3 p,
    float radius,  // 1.5 [0, 1000] [0, 5] m  How far the solid is moved out along x first.
    int count,
    int copy)
{
    float turn = polar_repeat_index(p, count, copy) * 2.0f * POLAR_REPEAT_PI / float(count);
    float out_along = p.x * cos(turn) + p.z * sin(turn);
    float across = p.z * cos(turn) - p.x * sin(turn);
    return vec3(out_along - radius, p.y, across);
}

float polar_repeat_distance(float acc, float d)
{
    return min(acc, d);
}

Box polar_repeat_bounds(float radius, Box child)
{
    float farthest_x = abs(child.centre.x + radius) + child.half_size.x;
    float reach = length(vec2(farthest_x, abs(child.centre.z) + child.half_size.z));
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(reach, child.half_size.y, reach));
}
