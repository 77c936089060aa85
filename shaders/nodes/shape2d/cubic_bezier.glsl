// Cubic Bezier: A curved stroke that two handles bend, with round ends. It is drawn in 48 straight pieces.
// field: exact; bound
// synonyms: curve, cubic curve, spline, pen, s curve, swoosh
float cubic_bezier_distance(
    vec2 p,
    vec2 start,          // (-0.6, -0.3) [-100, 100] [-2, 2] m  Where the stroke begins.
    vec2 start_handle,   // (-0.2, 1.2) [-100, 100] [-2, 2] m  Point that pulls the beginning of the stroke.
    vec2 finish_handle,  // (0.2, -1.2) [-100, 100] [-2, 2] m  Point that pulls the end of the stroke.
    vec2 finish,         // (0.6, 0.3) [-100, 100] [-2, 2] m  Where the stroke ends.
    float thickness)     // 0.18 [0.001, 100] [0.01, 2] m  Width of the stroke.
{
    vec2 linear = 3.0f * (start_handle - start);
    vec2 square = 3.0f * (finish_handle - 2.0f * start_handle + start);
    vec2 cube = finish - 3.0f * finish_handle + 3.0f * start_handle - start;
    vec2 from = p - start;
    vec2 origin = from;
    float squared = dot(from, from);
    for (int i = 1; i <= 48; i++) {
        float t = float(i) * (1.0f / 48.0f);
        vec2 to = origin - ((cube * t + square) * t + linear) * t;
        vec2 along = from - to;
        vec2 away = from - along * clamp(dot(from, along) / max(dot(along, along), 1.0e-20f), 0.0f, 1.0f);
        squared = min(squared, dot(away, away));
        from = to;
    }
    return sqrt(squared) - 0.5f * thickness;
}

Box cubic_bezier_bounds(vec2 start, vec2 start_handle, vec2 finish_handle, vec2 finish, float thickness)
{
    vec2 low = min(min(start, start_handle), min(finish_handle, finish));
    vec2 high = max(max(start, start_handle), max(finish_handle, finish));
    vec2 centre = 0.5f * (low + high);
    vec2 reach = 0.5f * (high - low) + vec2(0.5f * thickness);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
