// Coverage: the part of a pixel beyond an edge that its eye ray passes closely, outside or inside a surface.

// How an eye ray changes from a pixel to the next, across and up: between their points at the way t lies
// origin + t * direction.
struct Footprint {
    vec3 origin_x;
    vec3 origin_y;
    vec3 direction_x;
    vec3 direction_y;
};

// Stages of an edge: of other rays there is none; the eye ray walks; the closest approach is sought, by strides that grow
// and then by ones that halve; four taps before it and four behind it give the gradients there.
const int EDGE_IGNORED = 0;
const int EDGE_WATCHED = 1;
const int EDGE_REACHING = 2;
const int EDGE_NARROWING = 3;
const int EDGE_TAPS = 4;
const int EDGE_FOUND = 12;
const int EDGE_NONE = 13;

// Of the footprint's radius: how closely an approach is found, and how far taps lie from a point twice as far from it.
const float EDGE_PRECISION = 0.04f;

// An eye ray, and how close the surface came to its pixel. radius: of the circle around the pixel at the ray's origin,
// spread what it grows by per metre. t: where the approach that goes on was closest, ratio the signed one of distance and
// radius there, 1 before any. The passed ones: of the closest approach that the ray has left behind. side: 1 when the edge
// is that of what the ray hit, -1 when of what it passed.
struct Edge {
    Probe probe;
    float radius;
    float spread;
    int stage;
    float t;
    float ratio;
    float passed_t;
    float passed_ratio;
    float stride;
    float side;
    vec3 before;
    vec3 behind;
};

// What lies beyond the edge: its share of the pixel, and the way to it from the pixel's middle, in pixels.
struct Beyond {
    float share;
    vec2 way;
};

// The differences of a pixel's ray to those of the pixels beside and above it.
Footprint make_footprint(Ray ray, Ray beside, Ray above)
{
    Footprint footprint;
    footprint.origin_x = beside.origin - ray.origin;
    footprint.origin_y = above.origin - ray.origin;
    footprint.direction_x = beside.direction - ray.direction;
    footprint.direction_y = above.direction - ray.direction;
    return footprint;
}

Edge ignored_edge(Probe probe)
{
    Edge edge;
    edge.probe = probe;
    edge.radius = 0.0f;
    edge.spread = 0.0f;
    edge.stage = EDGE_IGNORED;
    edge.t = 0.0f;
    edge.ratio = 1.0f;
    edge.passed_t = 0.0f;
    edge.passed_ratio = 1.0f;
    edge.stride = 0.0f;
    edge.side = 1.0f;
    edge.before = vec3(0.0f);
    edge.behind = vec3(0.0f);
    return edge;
}

// Half a pixel's diagonal is the radius.
Edge watched_edge(Probe probe, Footprint footprint)
{
    Edge edge = ignored_edge(probe);
    edge.radius = 0.70710678f * max(length(footprint.origin_x), length(footprint.origin_y));
    edge.spread = 0.70710678f * max(length(footprint.direction_x), length(footprint.direction_y));
    edge.stage = EDGE_WATCHED;
    return edge;
}

float edge_radius(Edge edge, float t)
{
    return max(edge.radius + edge.spread * t, 1.0e-9f);
}

bool edge_done(Edge edge)
{
    return edge.stage <= EDGE_WATCHED ? probe_done(edge.probe) : edge.stage >= EDGE_FOUND;
}

// Corners of a tetrahedron, twice.
vec3 edge_corner(int tap)
{
    int corner = tap < 4 ? tap : tap - 4;
    float x = corner == 0 || corner == 3 ? 1.0f : -1.0f;
    float y = corner >= 2 ? 1.0f : -1.0f;
    float z = corner == 1 || corner == 3 ? 1.0f : -1.0f;
    return vec3(x, y, z);
}

// Where the next distance is wanted.
vec3 edge_point(Edge edge, March march)
{
    int tap = edge.stage - EDGE_TAPS;
    float size = tap >= 0 ? EDGE_PRECISION * edge_radius(edge, edge.t) : 0.0f;
    float along = tap >= 0 ? (tap < 4 ? -2.0f : 2.0f) * size : edge.stride;
    vec3 sought = edge.probe.origin + (edge.t + along) * edge.probe.direction + size * edge_corner(tap);
    return edge.stage <= EDGE_WATCHED ? probe_point(edge.probe, march) : sought;
}

// The search begins when the eye ray has ended: at what it passed most closely, or else where it hit.
Edge begun_search(Edge edge, March march)
{
    bool missed = probe_missed(edge.probe);
    bool passed = edge.passed_ratio < (missed ? edge.ratio : 1.0f);
    Edge next = edge;
    next.t = passed ? edge.passed_t : edge.t;
    next.ratio = passed ? edge.passed_ratio : edge.ratio;
    float radius = edge_radius(edge, next.t);
    float step = march.bisects != 0 ? march.constant_step : max(next.ratio, 4.0f * EDGE_PRECISION) * radius;
    next.side = passed || missed ? -1.0f : 1.0f;
    next.stride = passed || missed ? 0.5f * step : 1.5f * radius;
    int search = passed || missed ? EDGE_NARROWING : EDGE_REACHING;
    bool none = abs(next.ratio) >= 1.0f || edge.probe.exhausted != 0 || edge.probe.budget <= 0;
    next.stage = none ? EDGE_NONE : search;
    return next;
}

// One step of the eye ray, with the distance d where it was. An approach ends when the surface has left the circle.
Edge walked_edge(Edge edge, Probe after, float d, March march)
{
    float ratio = d / edge_radius(edge, edge.probe.t);
    bool walks = edge.stage == EDGE_WATCHED && edge.probe.phase == MARCHING;
    bool closer = walks && ratio < edge.ratio;
    bool leaves = walks && ratio >= 1.0f;
    bool passes = leaves && edge.ratio < edge.passed_ratio;
    Edge next = edge;
    next.probe = after;
    next.passed_t = passes ? edge.t : edge.passed_t;
    next.passed_ratio = passes ? edge.ratio : edge.passed_ratio;
    next.t = closer ? edge.probe.t : edge.t;
    next.ratio = closer ? ratio : (leaves ? 1.0f : edge.ratio);
    if (edge.stage == EDGE_WATCHED && probe_done(after)) {
        next = begun_search(next, march);
    }
    return next;
}

// One step of the search. Where the ray is so deep inside that the surface fills the circle, there is no edge; but a long
// stride may have reached into something else behind a gap, and is halved first.
Edge sought_edge(Edge edge, float d)
{
    float t = edge.t + edge.stride;
    float radius = edge_radius(edge, t);
    float ratio = d / radius;
    bool reaching = edge.stage == EDGE_REACHING;
    bool deep = ratio <= -1.0f;
    bool leaps = deep && reaching && edge.stride > 2.0f * radius;
    bool closer = ratio < edge.ratio && !leaps;
    Edge next = edge;
    next.t = closer ? t : edge.t;
    next.ratio = closer ? ratio : edge.ratio;
    next.stride = edge.stride * (closer ? (reaching ? 2.0f : 1.0f) : (leaps ? 0.5f : -0.5f));
    int search = closer && reaching ? EDGE_REACHING : EDGE_NARROWING;
    search = abs(next.stride) < EDGE_PRECISION * radius ? EDGE_TAPS : search;
    next.stage = deep && !leaps ? EDGE_NONE : search;
    return next;
}

Edge tapped_edge(Edge edge, float d)
{
    int tap = edge.stage - EDGE_TAPS;
    vec3 slope = d / (4.0f * EDGE_PRECISION * edge_radius(edge, edge.t)) * edge_corner(tap);
    Edge next = edge;
    next.before = edge.before + (tap < 4 ? 1.0f : 0.0f) * slope;
    next.behind = edge.behind + (tap < 4 ? 0.0f : 1.0f) * slope;
    next.stage = edge.stage + 1;
    return next;
}

// The edge after the distance d at edge_point; one that is done stays as it is. after: what the march makes of its probe.
Edge next_edge(Edge edge, Probe after, float d, March march)
{
    if (edge.stage >= EDGE_FOUND) {
        return edge;
    }
    if (edge.stage <= EDGE_WATCHED) {
        return walked_edge(edge, after, d, march);
    }
    Edge next = edge;
    if (edge.stage < EDGE_TAPS) {
        next = sought_edge(edge, d);
    } else {
        next = tapped_edge(edge, d);
    }
    next.probe.budget = edge.probe.budget - 1;
    next.stage = next.probe.budget <= 0 ? EDGE_NONE : next.stage;
    return next;
}

// Area of the unit square beyond a straight line. normal: of the line, a unit vector that points beyond it; way: from the
// square's middle to the line. A strip along one side, or a triangle in one corner.
float square_beyond(vec2 normal, float way)
{
    float a = max(abs(normal.x), abs(normal.y));
    float b = min(abs(normal.x), abs(normal.y));
    float corner = max(0.5f * (a + b) - way, 0.0f);
    float strip = 0.5f - way / max(a, 0.5f);
    float triangle = 0.5f * corner * corner / max(a * b, 1.0e-6f);
    return way <= 0.5f * (a - b) ? strip : triangle;
}

// The smallest distance along a ray is a function of the pixel. The edge is where it is 0; its slope is the field's
// gradient there, and in a kink the mean of those on both sides that has no part along the ray (docs/rendering.md).
Beyond edge_beyond(Edge edge, Footprint footprint)
{
    float falling = max(-dot(edge.before, edge.probe.direction), 0.0f) + 1.0e-3f;
    float rising = max(dot(edge.behind, edge.probe.direction), 0.0f) + 1.0e-3f;
    vec3 gradient = mix(edge.before, edge.behind, falling / (falling + rising));
    vec3 across = footprint.origin_x + edge.t * footprint.direction_x;
    vec3 up = footprint.origin_y + edge.t * footprint.direction_y;
    vec2 slope = vec2(dot(gradient, across), dot(gradient, up));
    float steepness = max(length(slope), 1.0e-9f);
    float d = edge.ratio * edge_radius(edge, edge.t);
    vec2 normal = edge.side / steepness * slope;
    float way = max(-edge.side * d, 0.0f) / steepness;
    float share = edge.stage == EDGE_FOUND ? square_beyond(normal, way) : 0.0f;
    float reach = 0.5f * (abs(normal.x) + abs(normal.y));
    Beyond beyond;
    beyond.share = share > 1.0f / 512.0f ? share : 0.0f;
    beyond.way = 0.5f * (way + reach) * normal;
    return beyond;
}

// The eye ray through the middle of that part.
Ray beyond_ray(Ray ray, Footprint footprint, Beyond beyond)
{
    Ray result = ray;
    result.origin = ray.origin + beyond.way.x * footprint.origin_x + beyond.way.y * footprint.origin_y;
    result.direction =
        normalize(ray.direction + beyond.way.x * footprint.direction_x + beyond.way.y * footprint.direction_y);
    return result;
}
