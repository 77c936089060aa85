// Uneven capsule: Two circles of different sizes with straight sides between them.
// The circles are kept apart so that neither swallows the other.
// field: exact
// synonyms: tapered capsule, bowling pin, bottle, rounded cone 2d
float uneven_capsule_length(float bottom_radius, float top_radius, float spacing)
{
    return max(spacing, 1.02f * abs(bottom_radius - top_radius));
}

float uneven_capsule_distance(
    vec2 p,
    float bottom_radius,  // 0.35 [0.001, 100] [0.05, 5] m  Radius of the lower circle.
    float top_radius,     // 0.2 [0.001, 100] [0.05, 5] m  Radius of the upper circle.
    float spacing)        // 0.5 [0.001, 200] [0.05, 5] m  Distance between the centres.
{
    float apart = uneven_capsule_length(bottom_radius, top_radius, spacing);
    vec2 q = vec2(abs(p.x), p.y + 0.5f * apart);
    float sine = (bottom_radius - top_radius) / apart;
    float cosine = sqrt(1.0f - sine * sine);
    float along = q.y * cosine - q.x * sine;
    float to_side = q.x * cosine + q.y * sine - bottom_radius;
    float to_bottom = length(q) - bottom_radius;
    float to_top = length(vec2(q.x, q.y - apart)) - top_radius;
    return along < 0.0f ? to_bottom : (along > cosine * apart ? to_top : to_side);
}

Box uneven_capsule_bounds(float bottom_radius, float top_radius, float spacing)
{
    float apart = uneven_capsule_length(bottom_radius, top_radius, spacing);
    float low = -0.5f * apart - bottom_radius;
    float high = 0.5f * apart + top_radius;
    float reach = max(bottom_radius, top_radius);
    return make_box(vec3(0.0f, 0.5f * (low + high), 0.0f), vec3(reach, 0.5f * (high - low), 0.0f));
}
