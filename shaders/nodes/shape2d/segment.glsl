// Segment: A straight stroke with round ends.
// field: exact
// synonyms: line, stroke, capsule 2d
float segment_distance(
    vec2 p,
    vec2 start,       // (-0.5, 0) [-100, 100] [-2, 2] m  Where the stroke begins.
    vec2 finish,      // (0.5, 0) [-100, 100] [-2, 2] m  Where the stroke ends.
    float thickness)  // 0.2 [0.001, 100] [0.01, 2] m  Width of the stroke.
{
    vec2 along = finish - start;
    vec2 from_start = p - start;
    float share = clamp(dot(from_start, along) / max(dot(along, along), 1.0e-12f), 0.0f, 1.0f);
    return length(from_start - along * share) - 0.5f * thickness;
}

Box segment_bounds(vec2 start, vec2 finish, float thickness)
{
    vec2 centre = 0.5f * (start + finish);
    vec2 reach = 0.5f * abs(finish - start) + vec2(0.5f * thickness);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
