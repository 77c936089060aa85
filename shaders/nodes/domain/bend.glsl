// Bend: Bends a solid that lies along x upwards into an arc; negative turns bend it downwards.
// The arc closes at most to a circle: what would reach round it again is cut off.
// field: bound
// synonyms: arc, curl, curve, banana, arch
const float BEND_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float bend_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * BEND_PI - angle : angle;
    angle = x < 0.0f ? BEND_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// Height above the arc through the origin, towards its centre; written so that a nearly straight arc keeps its digits.
float bend_rise(vec2 q, float curvature)
{
    float radius = length(vec2(curvature * q.x, 1.0f - curvature * q.y));
    return (2.0f * q.y - curvature * dot(q, q)) / (1.0f + radius);
}

vec3 bend_point(
    vec3 p,
    float turn)  // 45.0 [-360, 360] [-120, 120] deg/m  Turn per metre of length.
{
    float curvature = max(abs(turn), 1.0e-6f);
    float side = turn < 0.0f ? -1.0f : 1.0f;
    vec2 q = vec2(p.x, p.y * side);
    float along = bend_angle(1.0f - curvature * q.y, curvature * q.x) / curvature;
    return vec3(along, bend_rise(q, curvature) * side, p.z);
}

// Share of the arc's radius that stays free around its centre.
float bend_free(float curvature, float depth)
{
    return max(1.0f - curvature * depth, 0.2f);
}

// Around the arc's centre, and opposite the origin where both ends of the arc meet, the bent field jumps. The solid is
// cut off there, and guards that depend on the place alone, and are never zero, take over.
float bend_distance(
    vec3 p,
    float d,
    float turn,
    float depth)  // 0.5 [0, 100] [0, 5] m  How far the solid reaches towards the centre of the arc; more is cut off.
{
    float curvature = max(abs(turn), 1.0e-6f);
    vec2 q = vec2(p.x, turn < 0.0f ? -p.y : p.y);
    float free_share = bend_free(curvature, depth);
    float from_hole = bend_rise(q, curvature) - min(depth, 0.8f / curvature);
    vec2 from_centre = vec2(abs(q.x), q.y - 1.0f / curvature);
    float radius = length(from_centre);
    // The seam keeps a wedge of 14 degrees to both sides free.
    float from_seam = 0.24192190f * from_centre.y - 0.97029573f * from_centre.x;
    float solid = max(max(d, from_seam), from_hole);
    float hole_guard = max(from_hole, 1.25f * radius - 0.8f * free_share / curvature);
    float seam_guard = 0.24192190f * radius + (from_centre.y > 0.0f ? from_centre.x : radius);
    return min(solid, min(hole_guard, max(seam_guard, from_hole)));
}

// The guards let the bent field through only beyond four fifths of the free radius.
float bend_stretch(float turn, float depth)
{
    return 1.25f / bend_free(max(abs(turn), 1.0e-6f), depth);
}

Box bend_bounds(float turn, Box child)
{
    float curvature = max(abs(turn), 1.0e-6f);
    float side = turn < 0.0f ? -1.0f : 1.0f;
    float along = abs(child.centre.x) + child.half_size.x;
    float thick = abs(child.centre.y) + child.half_size.y;
    float reach = min(along, 1.0f / curvature) + thick;
    float rise = min(2.0f / curvature, 0.5f * curvature * along * along);
    vec3 centre = vec3(0.0f, 0.5f * side * rise, child.centre.z);
    return make_box(centre, vec3(reach, 0.5f * rise + thick, child.half_size.z));
}
