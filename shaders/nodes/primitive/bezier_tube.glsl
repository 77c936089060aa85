// Bezier tube: A round tube along a curve that leaves one point towards a second and ends in a third.
// field: exact; bound
// synonyms: curve, hose, cable, quadratic bezier, pipe
// Half the slope of the squared distance along the curve whose points are start + 2 t lead + t t bow.
float bezier_tube_slope(vec3 start, vec3 lead, vec3 bow, float t)
{
    return dot(start + t * (2.0f * lead + t * bow), lead + t * bow);
}

float bezier_tube_away(vec3 start, vec3 lead, vec3 bow, float t)
{
    vec3 away = start + t * (2.0f * lead + t * bow);
    return dot(away, away);
}

// Squared distance at the place where the slope changes its sign in a part where it does not turn.
float bezier_tube_nearest(vec3 start, vec3 lead, vec3 bow, float first, float last)
{
    float low = first;
    float high = last;
    float at_low = bezier_tube_slope(start, lead, bow, low);
    float at_high = bezier_tube_slope(start, lead, bow, high);
    for (int i = 0; i < 9; i++) {
        float middle = 0.5f * (low + high);
        float at_middle = bezier_tube_slope(start, lead, bow, middle);
        bool left = (at_middle < 0.0f) != (at_low < 0.0f);
        high = left ? middle : high;
        at_high = left ? at_middle : at_high;
        low = left ? low : middle;
        at_low = left ? at_low : at_middle;
    }
    float change = at_high - at_low;
    float share = abs(change) > 1.0e-12f ? clamp(-at_low / change, 0.0f, 1.0f) : 0.5f;
    return bezier_tube_away(start, lead, bow, mix(low, high, share));
}

float bezier_tube_distance(
    vec3 p,
    vec3 start,    // (-0.8, -0.4, 0.2) [-1000, 1000] [-5, 5] m  Where the curve begins.
    vec3 control,  // (0.0, 1.4, 0.0) [-1000, 1000] [-5, 5] m  Point that both ends head for.
    vec3 finish,   // (0.8, -0.4, -0.2) [-1000, 1000] [-5, 5] m  Where the curve ends.
    float radius)  // 0.15 [0.001, 100] [0.01, 2] m  Radius of the tube.
{
    vec3 from = start - p;
    vec3 lead = control - start;
    vec3 bow = finish - 2.0f * control + start;
    // The slope is a cubic; its own slope is zero at two places, which part it into pieces that only rise or fall.
    float square = 3.0f * dot(bow, bow);
    float half_linear = 3.0f * dot(lead, bow);
    float rest = 2.0f * dot(lead, lead) + dot(from, bow);
    float root = sqrt(max(half_linear * half_linear - square * rest, 0.0f));
    float first = clamp((-half_linear - root) / max(square, 1.0e-12f), 0.0f, 1.0f);
    float second = clamp((-half_linear + root) / max(square, 1.0e-12f), 0.0f, 1.0f);
    float squared = min(dot(from, from), bezier_tube_away(from, lead, bow, 1.0f));
    squared = min(squared, bezier_tube_nearest(from, lead, bow, 0.0f, first));
    squared = min(squared, bezier_tube_nearest(from, lead, bow, first, second));
    squared = min(squared, bezier_tube_nearest(from, lead, bow, second, 1.0f));
    return sqrt(squared) - radius;
}

Box bezier_tube_bounds(vec3 start, vec3 control, vec3 finish, float radius)
{
    vec3 middle = 0.25f * (start + 2.0f * control + finish);
    vec3 low = min(min(start, finish), 2.0f * middle - 0.5f * (start + finish));
    vec3 high = max(max(start, finish), 2.0f * middle - 0.5f * (start + finish));
    return grow_box(make_box(0.5f * (low + high), 0.5f * (high - low)), radius);
}
