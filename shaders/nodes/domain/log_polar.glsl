// Log-polar repeat: Rings of mirrored copies around the y axis, each ring smaller than the one around it.
// What leaves its cell is cut there.
// field: bound
// synonyms: droste, spiral, logarithmic, infinite zoom, shells, mandala
const float LOG_POLAR_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float log_polar_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * LOG_POLAR_PI - angle : angle;
    angle = x < 0.0f ? LOG_POLAR_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// Place within the ring, in sizes of the outermost, mirrored in every second ring.
float log_polar_ring(float place, float width, int rings)
{
    float index = clamp(floor(place / width + 0.5f), 1.0f - float(rings), 0.0f);
    float inside = place - index * width;
    bool odd = index - 2.0f * floor(0.5f * index) > 0.5f;
    return odd ? -inside : inside;
}

vec3 log_polar_point(
    vec3 p,
    float radius,  // 1.5 [0.01, 1000] [0.1, 5] m  Radius of the outermost ring, where solids keep their size.
    int count,     // 6 [1, 64] [2, 24]  Number of wedge pairs around the axis.
    float ratio,   // 2.2 [1.1, 100] [1.2, 5]  How many times as large a ring is as the next inside.
    int rings)     // 4 [1, 32] [1, 12]  Number of rings.
{
    float out_along = length(vec2(p.x, p.z));
    float reach = max(length(p), 1.0e-6f);
    float sector = 2.0f * LOG_POLAR_PI / float(count);
    float angle = log_polar_angle(p.x, p.z) / sector;
    float across = abs(angle - floor(angle + 0.5f)) * sector * out_along / reach;
    float ring = log_polar_ring(log(reach / radius), log(ratio), rings);
    return radius * vec3(ring, log_polar_angle(out_along, p.y), across);
}

// Distances shrink with the rings; none counts for more than half the way to the centre.
float log_polar_distance(vec3 p, float d, float radius)
{
    return clamp(d, -0.5f * radius, 0.5f * radius) * max(length(p), 1.0e-6f) / radius;
}

// The shear of the wedges towards the poles, and the change of scale.
float log_polar_lipschitz(int count)
{
    float slope = LOG_POLAR_PI / float(count);
    return 0.5f * (slope + sqrt(slope * slope + 4.0f)) + 0.5f;
}

Box log_polar_bounds(float radius, float ratio, Box child)
{
    float farthest = (child.centre.x + child.half_size.x) / radius;
    float reach = max(exp(min(farthest, 14.0f)), 1.0f / sqrt(ratio));
    return make_box(vec3(0.0f), vec3(farthest < 14.0f ? radius * reach * 1.0001f : UNBOUNDED));
}
