// Distance between points: How far two points are from each other, in metres.
// synonyms: length, separation, proximity, vector
float distance_between_value(
    vec3 first,   // (0, 0, 0) [-1000000, 1000000] [-10, 10] m  First point.
    vec3 second)  // (1, 0, 0) [-1000000, 1000000] [-10, 10] m  Second point.
{
    return length(second - first);
}
