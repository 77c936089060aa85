// Taper: Makes a solid narrower or wider towards its top.
// field: bound
// synonyms: narrow, cone, obelisk, draft, wedge, flare
float taper_size(
    float y,
    float top,
    float height)
{
    return mix(1.0f, top, clamp(y / height + 0.5f, 0.0f, 1.0f));
}

vec3 taper_point(
    vec3 p,
    float top,     // 0.4 [0.05, 20] [0.1, 3]  Width at the top, as a multiple of that at the bottom.
    float height)  // 2.0 [0.01, 1000] [0.1, 5] m  Height over which the width changes, half of it below the origin.
{
    float size = taper_size(p.y, top, height);
    return vec3(p.x / size, p.y, p.z / size);
}

float taper_distance(vec3 p, float d, float top, float height)
{
    return d * taper_size(p.y, top, height);
}

// Across the axis the factors cancel. Along it the slope of the width adds the lever of the solid's own surface: its
// radius, and its farthest height from where the width changes.
float taper_lipschitz(float top, float height, Box child)
{
    vec3 corner = abs(child.centre) + child.half_size;
    float slope = abs(top - 1.0f) / height;
    float lean = slope * length(vec2(corner.x, corner.z));
    float upright = max(top, 1.0f) + slope * (0.5f * height + corner.y);
    float sum = 1.0f + lean * lean + upright * upright;
    return sqrt(0.5f * (sum + sqrt(max(sum * sum - 4.0f * upright * upright, 0.0f))));
}

Box taper_bounds(float top, Box child)
{
    float widest = max(top, 1.0f);
    vec3 corner = abs(child.centre) + child.half_size;
    return make_box(vec3(0.0f, child.centre.y, 0.0f), vec3(corner.x * widest, child.half_size.y, corner.z * widest));
}
