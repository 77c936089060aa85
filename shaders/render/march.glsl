// March: one ray as a state machine that takes one distance at a time.

// Phases of a probe: walking up to MARCHING, then taps around the hit, then done. Shadow rays walk in phases below
// MARCHING, by the kind of their light's shadow. Six taps at most give the normal, 32 the occlusion.
const int MARCHING = 0;
const int NORMAL_TAP = 1;
const int OCCLUSION_TAP = 7;
const int HIT = 64;
const int MISSED = 65;

// Kinds of shadow, of lights that cast one: the phase of its ray is the kind's negative.
const int HARD_SHADOW = 1;
const int SOFT_SHADOW = 2;
const int CORRECTED_SHADOW = 3;

// Settings of the document. Lengths in metres, limits along the ray; occlusion_strength 0 leaves occlusion out, and
// normal_step 0 fits the taps to the distance. step_scale: of a step in distances. The last ones are structure: the
// renderer fixes them per program.
struct March {
    int step_limit;
    float minimum_step;
    float tolerance;
    float near_limit;
    float far_limit;
    int out_of_steps_hits;
    float step_scale;
    float constant_step;
    float normal_step;
    int occlusion_samples;
    float occlusion_strength;
    float occlusion_radius;
    int bisects;             // walks by constant steps, and halves the one that crossed the surface
    int central_normals;     // six taps on the axes instead of four at a tetrahedron's corners
    int smallest_occlusion;  // the smallest ratio of distance and height instead of the mean
    int tracks_cone;         // cone_ratio is wanted
#if TINTED_SHADOWS
    int tints_shadows;       // shadow rays look at what they hit, and go on behind glass
#endif
};

// budget: distances left to the pixel. exhausted: 1 when the step limit or the budget ended the ray. gradient: of the
// field at the hit. openness: 1 where nothing occludes; height: of the occlusion tap, less the first one's. stride: of the
// last step. cone_ratio: smallest ratio of distance and way along the ray (only when tracked), UNBOUNDED before any.
#if TINTED_SHADOWS
// Of soft shadow rays, which may go on behind what they come to, it is the smallest of what they have passed, at the distance
// `nearest`; the next larger one follows. last_ratio: the newest one, which may yet fall; negative while the ray leaves the glass
// that it went through.
#endif
struct Probe {
    vec3 origin;
    vec3 direction;
    float t;
    float t_end;
    int phase;
    int steps;
    int budget;
    int exhausted;
    vec3 gradient;
    float openness;
    float height;
    float stride;
    float cone_ratio;
#if TINTED_SHADOWS
    float last_ratio;
    float nearest;
    float second_ratio;
    float second_nearest;
#endif
};

Probe make_probe(vec3 origin, vec3 direction, float t, float t_end, int phase, int budget)
{
    Probe probe;
    probe.origin = origin;
    probe.direction = direction;
    probe.t = t;
    probe.t_end = t_end;
    probe.phase = budget > 0 ? phase : MISSED;
    probe.steps = 0;
    probe.budget = budget;
    probe.exhausted = budget > 0 ? 0 : 1;
    probe.gradient = vec3(0.0f);
    probe.openness = 1.0f;
    probe.height = 0.0f;
    probe.stride = UNBOUNDED;
    probe.cone_ratio = UNBOUNDED;
#if TINTED_SHADOWS
    probe.last_ratio = UNBOUNDED;
    probe.nearest = 0.0f;
    probe.second_ratio = UNBOUNDED;
    probe.second_nearest = 0.0f;
#endif
    return probe;
}

Probe eye_probe(Ray ray, March march, int budget)
{
    return make_probe(ray.origin, ray.direction, march.near_limit, march.far_limit, MARCHING, budget);
}

// Starts off the surface by more than the marcher may have stepped into it. A surface that faces away is blocked at once.
Probe shadow_probe(vec3 position, vec3 normal, Light light, int shadow, March march, int budget)
{
    float offset = 4.0f * march.tolerance + 2.0f * march.minimum_step;
    int phase = dot(normal, light.direction) > 0.0f ? -shadow : HIT;
    float t_end = min(light.range, march.far_limit);
    return make_probe(position + offset * normal, light.direction, 0.0f, t_end, phase, budget);
}

bool probe_done(Probe probe)
{
    return probe.phase >= HIT;
}

bool probe_missed(Probe probe)
{
    return probe.phase == MISSED;
}

// What a shadow ray that is done leaves of its light: 0 to 1. Soft edges are eased as a round light's are.
float shadow_visibility(Probe probe, Light light, int shadow)
{
    float reached = 1.0f;
#if CONES
    float open = clamp(light.sharpness * probe.cone_ratio, 0.0f, 1.0f);
    float soft = open * open * (3.0f - 2.0f * open);
    reached = shadow == HARD_SHADOW ? 1.0f : soft;
#endif
    return probe.phase == MISSED ? reached : 0.0f;
}

// Where a tap for the gradient lies, in tap sizes: corners of a tetrahedron, or both ways along the axes.
vec3 tap_corner(int phase, March march)
{
    float x = phase == 1 || phase == 4 ? 1.0f : -1.0f;
    float y = phase >= 3 ? 1.0f : -1.0f;
    float z = phase == 2 || phase == 4 ? 1.0f : -1.0f;
    float side = phase == 1 || phase == 3 || phase == 5 ? 1.0f : -1.0f;
    vec3 axis = vec3(phase <= 2 ? side : 0.0f, phase == 3 || phase == 4 ? side : 0.0f, phase >= 5 ? side : 0.0f);
    return march.central_normals != 0 ? axis : vec3(x, y, z);
}

float tap_size(Probe probe, March march)
{
    return march.normal_step > 0.0f ? march.normal_step : 2.0e-4f * max(1.0f, probe.t);
}

// Of the first occlusion tap, and from one to the next.
float occlusion_step(March march)
{
    return march.occlusion_radius / float(march.occlusion_samples);
}

// Unit normal at the hit; faces the eye where the field is flat.
vec3 probe_normal(Probe probe)
{
    float slope = length(probe.gradient);
    return slope > 1.0e-6f ? probe.gradient / max(slope, 1.0e-6f) : -probe.direction;
}

// Where the next distance is wanted; the hit once the probe is done.
vec3 probe_point(Probe probe, March march)
{
    bool normal_tap = probe.phase >= NORMAL_TAP && probe.phase < OCCLUSION_TAP;
    bool occlusion_tap = probe.phase >= OCCLUSION_TAP && probe.phase < HIT;
    vec3 corner = (normal_tap ? tap_size(probe, march) : 0.0f) * tap_corner(probe.phase, march);
    vec3 above = (occlusion_tap ? probe.height + occlusion_step(march) : 0.0f) * probe_normal(probe);
    return probe.origin + probe.t * probe.direction + corner + above;
}

// Where a walk that ended at the surface goes on: normal taps for the eye, nothing for a shadow.
int surface_phase(int phase)
{
    return phase < MARCHING ? HIT : NORMAL_TAP;
}

// The phase after a tap. `height`: of the next occlusion tap, less the first one's.
int tapped_phase(Probe probe, float height, March march)
{
    int last_normal = march.central_normals != 0 ? NORMAL_TAP + 5 : NORMAL_TAP + 3;
    int after_normal = march.occlusion_strength > 0.0f ? OCCLUSION_TAP : HIT;
    int next = probe.phase == last_normal ? after_normal : probe.phase + 1;
    float highest = march.occlusion_radius - 0.999f * occlusion_step(march);
    int above = height > highest ? HIT : next;
    return probe.phase >= OCCLUSION_TAP ? above : next;
}

// The probe after its walk found that it hit, missed (flags, 0 or 1) or goes on at t_next, or after a tap that leads to
// the phase `tapped`. Flags and not branches: plain selections, which the CPU's vectoriser takes.
Probe settle(Probe probe, int hit, int missed, float t_hit, float t_next, int tapped, March march)
{
    int going = probe.phase < HIT ? 1 : 0;
    int walking = probe.phase <= MARCHING ? 1 : 0;
    int steps = probe.steps + walking;
    int stopped = steps >= march.step_limit ? walking - hit - missed : 0;
    int surface = march.out_of_steps_hits != 0 ? hit + stopped : hit;

    int walked = missed + stopped > 0 ? MISSED : probe.phase;
    walked = surface > 0 ? surface_phase(probe.phase) : walked;
#if TINTED_SHADOWS
    int looked = surface > 0 ? NORMAL_TAP : walked;
    walked = march.tints_shadows != 0 ? looked : walked;
#endif
    int phase = walking > 0 ? walked : tapped;

    int spent = probe.budget <= 1 ? going : 0;
    spent = phase < HIT ? spent : 0;
    int spent_phase = march.out_of_steps_hits != 0 ? HIT : MISSED;
    spent_phase = hit + 1 - walking > 0 ? HIT : spent_phase;
    phase = spent > 0 ? spent_phase : phase;

    float t_walked = missed + stopped > 0 ? probe.t : t_next;
    t_walked = hit > 0 ? t_hit : t_walked;

    Probe next = probe;
    next.t = walking > 0 ? t_walked : probe.t;
    next.phase = going > 0 ? phase : probe.phase;
    next.steps = steps;
    next.budget = probe.budget - going;
    next.exhausted = max(probe.exhausted, max(stopped, spent));
    return next;
}

// How much higher the next occlusion tap lies: a step, or for the smallest ratio as far as the distance allows.
float occlusion_rise(float d, March march)
{
    float rise = occlusion_step(march);
    return march.smallest_occlusion != 0 ? max(d, rise) : rise;
}

// The probe after the distance d at probe_point; a probe that is done stays as it is.
Probe advance(Probe probe, float d, March march)
{
    int walking = probe.phase <= MARCHING ? 1 : 0;
    float t_next = probe.t + max(d * march.step_scale, march.minimum_step);
    float t_hit = probe.t + clamp(d, -march.minimum_step, 0.0f);
    int hit = d < march.tolerance ? walking : 0;
    int missed = t_next >= probe.t_end ? walking - hit : 0;

    float occlusion_weight = probe.phase >= OCCLUSION_TAP ? 1.0f : 0.0f;
    occlusion_weight = probe.phase >= HIT ? 0.0f : occlusion_weight;
    float height = probe.height + occlusion_weight * occlusion_rise(d, march);
    Probe next = settle(probe, hit, missed, t_hit, t_next, tapped_phase(probe, height, march), march);

    float tap_weight = probe.phase >= NORMAL_TAP ? 1.0f : 0.0f;
    tap_weight = probe.phase >= OCCLUSION_TAP ? 0.0f : tap_weight;
    float taps = march.central_normals != 0 ? 2.0f : 4.0f;
    float slope = tap_weight * d / (taps * tap_size(probe, march));
    next.gradient = probe.gradient + slope * tap_corner(probe.phase, march);

    float open_height = (probe.height + occlusion_step(march)) * clamp(length(probe.gradient), 0.1f, 1.0f);
    float blocked = march.occlusion_strength * (1.0f - clamp(d / max(open_height, 1.0e-6f), 0.0f, 1.0f));
    float mean = probe.openness - blocked / float(march.occlusion_samples);
    float smallest = min(probe.openness, 1.0f - blocked);
    float openness = march.smallest_occlusion != 0 ? smallest : mean;
    next.openness = occlusion_weight > 0.0f ? openness : probe.openness;
    next.height = height;
    return next;
}

#if BISECTS
// The same for walks by constant steps: the step that crossed the surface is halved until it is shorter than the
// tolerance. Finds what the sign of the field tells, whatever its slope; passes through what is thinner than a step.
Probe advance_bisecting(Probe probe, float d, March march)
{
    int walking = probe.phase <= MARCHING ? 1 : 0;
    float stride = min(probe.stride, march.constant_step);
    bool crossed = d <= 0.0f || stride < march.constant_step;
    float next_stride = crossed ? 0.5f * stride : stride;
    float t_next = probe.t + (d > 0.0f ? next_stride : -next_stride);
    bool close = abs(d) < march.tolerance || next_stride < 0.5f * march.tolerance;
    bool blocked = d <= 0.0f && (probe.phase < MARCHING || probe.steps == 0);
    int hit = close || blocked ? walking : 0;
    int missed = t_next >= probe.t_end && !crossed ? walking - hit : 0;

    Probe tapped = advance(probe, d, march);
    Probe next = settle(probe, hit, missed, probe.t, t_next, tapped.phase, march);
    next.gradient = tapped.gradient;
    next.openness = tapped.openness;
    next.height = tapped.height;
    next.stride = walking > 0 ? next_stride : probe.stride;
    return next;
}
#endif

#if TINTED_SHADOWS
// A shadow ray `before` and after a step, at the point of which the ratio counts or not. What it passed is known when the ratio
// rises: the last one was the smallest. Minima within a tenth of the way are of one thing: beside flat sides there are many.
Probe passed(Probe before, Probe after, float ratio, bool counts)
{
    bool in_the_open = before.phase < -HARD_SHADOW && counts;
    bool leaves = before.last_ratio < 0.0f;
    bool rises = ratio > abs(before.last_ratio);
    bool passes = in_the_open && rises && !leaves;
    float place = before.t - before.stride, last = leaves && rises ? -ratio : ratio;
    bool is_first = passes && before.last_ratio < before.cone_ratio;
    bool other = place - before.nearest > 0.1f * place;
    bool is_second = passes && other && !is_first && before.last_ratio < before.second_ratio;
    bool moves_down = is_first && other;
    Probe next = after;
    next.second_ratio = moves_down ? before.cone_ratio : (is_second ? before.last_ratio : before.second_ratio);
    next.second_nearest = moves_down ? before.nearest : (is_second ? place : before.second_nearest);
    next.cone_ratio = is_first ? before.last_ratio : before.cone_ratio;
    next.nearest = is_first ? place : before.nearest;
    next.last_ratio = in_the_open ? last : before.last_ratio;
    return next;
}

#endif
#if CONES
// The probe `after` the distance d of `before`, with the ratio of the two points. For a corrected shadow it is that of the
// closest approach between the last two points, when both see the same point of the surface: the triangle of the stride,
// the last distance and this one has its height there (docs/shadows.md). A distance that ended the ray does not count,
// so that nothing beyond a light softens its shadows.
Probe narrowed(Probe before, Probe after, float d, March march)
{
    float stride = before.stride, last = stride / march.step_scale;
    float back = clamp(((stride - last) * (stride + last) + d * d) / (2.0f * stride), 0.0f, stride);
    back = before.phase == -CORRECTED_SHADOW ? back : 0.0f;
    back = march.bisects != 0 ? 0.0f : back;
    float ratio = sqrt(max(d * d - back * back, 0.0f)) / max(before.t - back, 1.0e-6f);
    bool counts = before.phase <= MARCHING && after.phase == before.phase && before.t > 0.0f;
    Probe next = after;
    next.cone_ratio = counts ? min(before.cone_ratio, ratio) : before.cone_ratio;
    next.stride = march.bisects != 0 ? after.stride : max(after.t - before.t, 1.0e-6f);
#if TINTED_SHADOWS
    Probe passing = passed(before, next, ratio, counts);
    bool is_shadow = before.phase < MARCHING && march.tints_shadows != 0;
    next.cone_ratio = is_shadow ? passing.cone_ratio : next.cone_ratio;
    next.nearest = passing.nearest;
    next.second_ratio = passing.second_ratio;
    next.second_nearest = passing.second_nearest;
    next.last_ratio = passing.last_ratio;
#endif
    return next;
}
#endif
