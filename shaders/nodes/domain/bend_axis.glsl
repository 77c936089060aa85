// Bend along axis: Bends a solid that lies along any axis into an arc; negative turns bend it the other way.
// The arc closes at most to a circle: what would reach round it again is cut off.
// field: bound
// synonyms: arc, curl, curve, arch, fold over
const float BEND_AXIS_PI = 3.14159265f;

// Angle of (x, y) from the x axis; 0 at the origin.
float bend_axis_angle(float x, float y)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, 1.0e-20f);
    float s = ratio * ratio;
    float series = 0.0964792594f + s * (-0.0559820272f + s * (0.0219068322f - s * 0.00406573853f));
    series = 0.999999344f + s * (-0.333299309f + s * (0.199471861f + s * (-0.139112115f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 0.5f * BEND_AXIS_PI - angle : angle;
    angle = x < 0.0f ? BEND_AXIS_PI - angle : angle;
    return y < 0.0f ? -angle : angle;
}

// The components along, towards and across.
vec3 bend_axis_sorted(vec3 v, int axes)
{
    vec3 result = axes == 0 ? v : vec3(v.x, v.z, v.y);
    result = axes == 2 ? vec3(v.y, v.x, v.z) : result;
    result = axes == 3 ? vec3(v.y, v.z, v.x) : result;
    result = axes == 4 ? vec3(v.z, v.x, v.y) : result;
    return axes == 5 ? vec3(v.z, v.y, v.x) : result;
}

vec3 bend_axis_restored(vec3 v, int axes)
{
    vec3 result = axes == 0 ? v : vec3(v.x, v.z, v.y);
    result = axes == 2 ? vec3(v.y, v.x, v.z) : result;
    result = axes == 3 ? vec3(v.z, v.x, v.y) : result;
    result = axes == 4 ? vec3(v.y, v.z, v.x) : result;
    return axes == 5 ? vec3(v.z, v.y, v.x) : result;
}

// Height above the arc through the origin, towards its centre; written so that a nearly straight arc keeps its digits.
float bend_axis_rise(vec2 q, float curvature)
{
    float radius = length(vec2(curvature * q.x, 1.0f - curvature * q.y));
    return (2.0f * q.y - curvature * dot(q, q)) / (1.0f + radius);
}

vec3 bend_axis_point(
    vec3 p,
    int axes,    // y_to_x {x_to_y, x_to_z, y_to_x, y_to_z, z_to_x, z_to_y}  Which axis bends towards which.
    float turn)  // 45.0 [-360, 360] [-120, 120] deg/m  Turn per metre of length.
{
    vec3 v = bend_axis_sorted(p, axes);
    float curvature = max(abs(turn), 1.0e-6f);
    float side = turn < 0.0f ? -1.0f : 1.0f;
    vec2 q = vec2(v.x, v.y * side);
    float along = bend_axis_angle(1.0f - curvature * q.y, curvature * q.x) / curvature;
    return bend_axis_restored(vec3(along, bend_axis_rise(q, curvature) * side, v.z), axes);
}

// Share of the arc's radius that stays free around its centre.
float bend_axis_free(float curvature, float depth)
{
    return max(1.0f - curvature * depth, 0.2f);
}

// Around the arc's centre, and opposite the origin where both ends of the arc meet, the bent field jumps. The solid is
// cut off there, and guards that depend on the place alone, and are never zero, take over.
float bend_axis_distance(
    vec3 p,
    float d,
    int axes,
    float turn,
    float depth)  // 0.5 [0, 100] [0, 5] m  How far the solid reaches towards the centre of the arc; more is cut off.
{
    vec3 v = bend_axis_sorted(p, axes);
    float curvature = max(abs(turn), 1.0e-6f);
    vec2 q = vec2(v.x, turn < 0.0f ? -v.y : v.y);
    float free_share = bend_axis_free(curvature, depth);
    float from_hole = bend_axis_rise(q, curvature) - min(depth, 0.8f / curvature);
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
float bend_axis_stretch(float turn, float depth)
{
    return 1.25f / bend_axis_free(max(abs(turn), 1.0e-6f), depth);
}

Box bend_axis_bounds(int axes, float turn, Box child)
{
    vec3 middle = bend_axis_sorted(child.centre, axes);
    vec3 half_size = bend_axis_sorted(child.half_size, axes);
    float curvature = max(abs(turn), 1.0e-6f);
    float side = turn < 0.0f ? -1.0f : 1.0f;
    float along = abs(middle.x) + half_size.x;
    float thick = abs(middle.y) + half_size.y;
    float reach = min(along, 1.0f / curvature) + thick;
    float rise = min(2.0f / curvature, 0.5f * curvature * along * along);
    vec3 centre = vec3(0.0f, 0.5f * side * rise, middle.z);
    return make_box(bend_axis_restored(centre, axes),
                    bend_axis_restored(vec3(reach, 0.5f * rise + thick, half_size.z), axes));
}
