// Tapered extrude: Pulls a flat shape out along z and makes it narrower or wider on the way.
// field: bound
// synonyms: draft angle, pyramid, frustum, 2d to 3d, push pull, narrow
float extrude_tapered_size(float z, float depth, float front)
{
    return mix(1.0f, front, clamp(z / depth + 0.5f, 0.0f, 1.0f));
}

vec2 extrude_tapered_point(
    vec3 p,
    float depth,  // 1.0 [0.001, 200] [0.01, 5] m  Length from end to end; half of it lies behind the shape.
    float front)  // 0.5 [0.02, 20] [0.1, 3]  Width at the front end, as a multiple of that at the back.
{
    return vec2(p.x, p.y) / extrude_tapered_size(p.z, depth, front);
}

float extrude_tapered_distance(vec3 p, float d, float depth, float front)
{
    float side = d * extrude_tapered_size(p.z, depth, front);
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(side, 0.0f), max(cap, 0.0f))) + min(max(side, cap), 0.0f);
}

// Along z the distance changes by the lever of the shape's own outline; beyond the ends the width stays.
float extrude_tapered_lipschitz(float depth, float front, Box child)
{
    vec3 corner = abs(child.centre) + child.half_size;
    float lean = abs(front - 1.0f) / depth * length(vec2(corner.x, corner.y));
    return sqrt(1.0f + lean * lean);
}

Box extrude_tapered_bounds(float depth, float front, Box child)
{
    float widest = max(front, 1.0f);
    vec3 corner = abs(child.centre) + child.half_size;
    return make_box(vec3(0.0f), vec3(corner.x * widest, corner.y * widest, 0.5f * depth));
}
