// Twisted extrude: Pulls a flat shape out along z and turns it on the way, like a drill.
// field: bound
// synonyms: screw, drill, auger, barley sugar, 2d to 3d, push pull
vec2 extrude_twisted_point(
    vec3 p,
    float depth,  // 1.0 [0.001, 200] [0.01, 5] m  Length from end to end; half of it lies behind the shape.
    float turn)   // 90.0 [-3600, 3600] [-360, 360] deg/m  Turn per metre.
{
    float angle = turn * clamp(p.z, -0.5f * depth, 0.5f * depth);
    return vec2(p.x * cos(angle) + p.y * sin(angle), p.y * cos(angle) - p.x * sin(angle));
}

float extrude_twisted_distance(vec3 p, float d, float depth)
{
    float cap = abs(p.z) - 0.5f * depth;
    return length(vec2(max(d, 0.0f), max(cap, 0.0f))) + min(max(d, cap), 0.0f);
}

float extrude_twisted_reach(Box child)
{
    vec3 corner = abs(child.centre) + child.half_size;
    return length(vec2(corner.x, corner.y));
}

// Along z the distance changes by the lever of the shape's own outline; beyond the ends the turn stays.
float extrude_twisted_lipschitz(float turn, Box child)
{
    float slope = turn * extrude_twisted_reach(child);
    return sqrt(1.0f + slope * slope);
}

Box extrude_twisted_bounds(float depth, Box child)
{
    float reach = extrude_twisted_reach(child);
    return make_box(vec3(0.0f), vec3(reach, reach, 0.5f * depth));
}
