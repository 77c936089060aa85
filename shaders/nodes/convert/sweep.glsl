// Sweep: Moves a flat shape along a curve that leaves one point towards a second and ends in a third.
// The shape's x axis stays across the plane of the curve. What reaches farther than a third of the radius of the
// tightest bend is cut off, so that the sweep never folds over itself.
// field: bound
// synonyms: path extrude, along curve, pipe, rail, moulding, bezier, 2d to 3d
// Half the slope of the squared distance along the curve whose points are start + 2 t lead + t t bow.
float sweep_slope(vec3 start, vec3 lead, vec3 bow, float t)
{
    return dot(start + t * (2.0f * lead + t * bow), lead + t * bow);
}

vec3 sweep_away(vec3 start, vec3 lead, vec3 bow, float t)
{
    return start + t * (2.0f * lead + t * bow);
}

// Where the slope changes its sign in a part where it does not turn.
float sweep_root(vec3 start, vec3 lead, vec3 bow, float first, float last)
{
    float low = first;
    float high = last;
    bool falls = sweep_slope(start, lead, bow, low) < 0.0f;
    for (int i = 0; i < 10; i++) {
        float middle = 0.5f * (low + high);
        bool left = (sweep_slope(start, lead, bow, middle) < 0.0f) != falls;
        high = left ? middle : high;
        low = left ? low : middle;
    }
    float at_low = sweep_slope(start, lead, bow, low);
    float change = sweep_slope(start, lead, bow, high) - at_low;
    float share = abs(change) > 1.0e-12f ? clamp(-at_low / change, 0.0f, 1.0f) : 0.5f;
    return mix(low, high, share);
}

float sweep_nearer(vec3 start, vec3 lead, vec3 bow, float a, float b)
{
    vec3 at_a = sweep_away(start, lead, bow, a);
    vec3 at_b = sweep_away(start, lead, bow, b);
    return dot(at_b, at_b) < dot(at_a, at_a) ? b : a;
}

// Where the curve is nearest, 0 at its start and 1 at its end.
float sweep_nearest(vec3 from, vec3 lead, vec3 bow)
{
    // The slope is a cubic; its own slope is zero at two places, which part it into pieces that only rise or fall.
    float square = 3.0f * dot(bow, bow);
    float half_linear = 3.0f * dot(lead, bow);
    float rest = 2.0f * dot(lead, lead) + dot(from, bow);
    float root = sqrt(max(half_linear * half_linear - square * rest, 0.0f));
    float first = clamp((-half_linear - root) / max(square, 1.0e-12f), 0.0f, 1.0f);
    float second = clamp((-half_linear + root) / max(square, 1.0e-12f), 0.0f, 1.0f);
    float best = sweep_nearer(from, lead, bow, 0.0f, 1.0f);
    best = sweep_nearer(from, lead, bow, best, sweep_root(from, lead, bow, 0.0f, first));
    best = sweep_nearer(from, lead, bow, best, sweep_root(from, lead, bow, first, second));
    return sweep_nearer(from, lead, bow, best, sweep_root(from, lead, bow, second, 1.0f));
}

vec3 sweep_direction(vec3 lead, vec3 bow, float t)
{
    vec3 along = lead + t * bow;
    return along / max(length(along), 1.0e-6f);
}

// Across the plane of the curve; of a straight one, across the plane of it and the axis it is least along.
vec3 sweep_across(vec3 lead, vec3 bow)
{
    vec3 across = cross(lead, bow);
    float size = length(across);
    vec3 axis = abs(lead.z) < 0.7f * length(lead) ? vec3(0.0f, 0.0f, 1.0f) : vec3(0.0f, 1.0f, 0.0f);
    vec3 other = cross(lead, cross(axis, lead));
    bool straight = size < 1.0e-5f * dot(lead, lead);
    return straight ? other / max(length(other), 1.0e-9f) : across / max(size, 1.0e-12f);
}

// Least length of lead + t bow on the way.
float sweep_least_speed(vec3 lead, vec3 bow)
{
    float t = clamp(-dot(lead, bow) / max(dot(bow, bow), 1.0e-12f), 0.0f, 1.0f);
    return length(lead + t * bow);
}

float sweep_tube(vec3 lead, vec3 bow, float reach)
{
    float speed = sweep_least_speed(lead, bow);
    float bend = 2.0f * speed * speed * speed / max(length(cross(lead, bow)), 1.0e-9f);
    return min(reach, 0.333f * bend);
}

vec2 sweep_point(
    vec3 p,
    vec3 start,    // (-0.9, -0.5, 0) [-1000, 1000] [-5, 5] m  Where the curve begins.
    vec3 control,  // (0, 1.4, 0) [-1000, 1000] [-5, 5] m  Point that both ends head for.
    vec3 finish)   // (0.9, -0.5, 0) [-1000, 1000] [-5, 5] m  Where the curve ends.
{
    vec3 lead = control - start;
    vec3 bow = finish - 2.0f * control + start;
    float t = sweep_nearest(start - p, lead, bow);
    vec3 away = -sweep_away(start - p, lead, bow, t);
    vec3 across = sweep_across(lead, bow);
    return vec2(dot(away, across), dot(away, cross(across, sweep_direction(lead, bow, t))));
}

float sweep_distance(
    vec3 p,
    float d,
    vec3 start,
    vec3 control,
    vec3 finish,
    float reach)  // 0.4 [0.001, 100] [0.05, 2] m  How far from the curve the shape reaches; what is farther is cut off.
{
    vec3 lead = control - start;
    vec3 bow = finish - 2.0f * control + start;
    float tube = sweep_tube(lead, bow, reach);
    float t = sweep_nearest(start - p, lead, bow);
    vec3 away = -sweep_away(start - p, lead, bow, t);
    float past = dot(away, sweep_direction(lead, bow, t)) * (t < 0.5f ? -1.0f : 1.0f);
    float r = length(away);
    float side = max(d, sqrt(max(r * r - past * past, 0.0f)) - tube);
    // Before the end: two thirds of the way along the curve to it, which is no more than the way to its face.
    float before = -1.333f * sweep_least_speed(lead, bow) * min(t, 1.0f - t);
    float face = t > 0.0f && t < 1.0f ? before : max(past, 0.0f);
    float near = length(vec2(max(side, 0.0f), max(face, 0.0f))) + min(max(side, face), 0.0f);
    return r < 3.0f * tube ? min(near, 2.0f * tube) : r - tube;
}

Box sweep_bounds(vec3 start, vec3 control, vec3 finish, float reach)
{
    vec3 middle = 0.25f * (start + 2.0f * control + finish);
    vec3 low = min(min(start, finish), 2.0f * middle - 0.5f * (start + finish));
    vec3 high = max(max(start, finish), 2.0f * middle - 0.5f * (start + finish));
    return grow_box(make_box(0.5f * (low + high), 0.5f * (high - low)), reach);
}
