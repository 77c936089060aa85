// Lens: A pointed oval whose two sides bulge differently.
// field: exact
// synonyms: optical lens, asymmetric vesica, leaf, eye, almond
float lens_bulge(float bulge, float half_height)
{
    return clamp(bulge, 0.02f * half_height, half_height);
}

// Distance to the circle that one side is an arc of; x points outwards on that side.
float lens_arc(vec2 q, float bulge, float half_height)
{
    float offset = 0.5f * (half_height * half_height - bulge * bulge) / bulge;
    return length(vec2(q.x + offset, q.y)) - (offset + bulge);
}

float lens_distance(
    vec2 p,
    float left_bulge,   // 0.15 [0.001, 100] [0.02, 5] m  How far the left side bulges: 1/50 to 1 of the half height.
    float right_bulge,  // 0.35 [0.001, 100] [0.02, 5] m  How far the right side bulges.
    float half_height)  // 0.6 [0.001, 100] [0.05, 5] m  Distance from the centre to the tips.
{
    float left = lens_bulge(left_bulge, half_height);
    float right = lens_bulge(right_bulge, half_height);
    vec2 q = vec2(p.x, abs(p.y));
    float within = max(lens_arc(q, right, half_height), lens_arc(vec2(-q.x, q.y), left, half_height));
    float bulge = q.x > 0.0f ? right : left;
    vec2 r = abs(p);
    float offset = 0.5f * (half_height * half_height - bulge * bulge) / bulge;
    bool at_tip = (r.y - half_height) * offset > r.x * half_height;
    float around = at_tip ? length(vec2(r.x, r.y - half_height)) : lens_arc(r, bulge, half_height);
    return within < 0.0f ? within : around;
}

Box lens_bounds(float left_bulge, float right_bulge, float half_height)
{
    float left = lens_bulge(left_bulge, half_height);
    float right = lens_bulge(right_bulge, half_height);
    return make_box(vec3(0.5f * (right - left), 0.0f, 0.0f), vec3(0.5f * (left + right), half_height, 0.0f));
}
