// March: one ray as a state machine that takes one distance at a time.

// Phases of a probe. From NORMAL_TAP four distances give the normal, from OCCLUSION_TAP five give the occlusion.
const int SHADOWING = -1;
const int MARCHING = 0;
const int NORMAL_TAP = 1;
const int OCCLUSION_TAP = 5;
const int HIT = 10;
const int MISSED = 11;

// Settings of the document. Lengths in metres, limits along the ray; occlusion_strength 0 leaves occlusion out.
struct March {
    int step_limit;
    float minimum_step;
    float tolerance;
    float near_limit;
    float far_limit;
    int out_of_steps_hits;
    float occlusion_strength;
    float occlusion_radius;
};

// budget: distances left to the pixel. exhausted: 1 when the step limit or the budget ended the ray. gradient: of the
// field at the hit. openness: 1 where nothing occludes.
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
    return probe;
}

Probe eye_probe(Ray ray, March march, int budget)
{
    return make_probe(ray.origin, ray.direction, march.near_limit, march.far_limit, MARCHING, budget);
}

// Starts off the surface by more than the marcher may have stepped into it. A surface that faces away is blocked at once.
Probe shadow_probe(vec3 position, vec3 normal, Light light, March march, int budget)
{
    float offset = 4.0f * march.tolerance + 2.0f * march.minimum_step;
    int phase = dot(normal, light.direction) > 0.0f ? SHADOWING : HIT;
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

// Corner of the tetrahedron whose four distances give the gradient.
vec3 tap_corner(int phase)
{
    float x = phase == 1 || phase == 4 ? 1.0f : -1.0f;
    float y = phase >= 3 ? 1.0f : -1.0f;
    float z = phase == 2 || phase == 4 ? 1.0f : -1.0f;
    return vec3(x, y, z);
}

float tap_size(Probe probe)
{
    return 2.0e-4f * max(1.0f, probe.t);
}

float occlusion_height(Probe probe, March march)
{
    return 0.2f * march.occlusion_radius * float(max(probe.phase - OCCLUSION_TAP + 1, 1));
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
    vec3 corner = (normal_tap ? tap_size(probe) : 0.0f) * tap_corner(probe.phase);
    vec3 above = (occlusion_tap ? occlusion_height(probe, march) : 0.0f) * probe_normal(probe);
    return probe.origin + probe.t * probe.direction + corner + above;
}

// Where a walk that ended at the surface goes on: normal taps for the eye, nothing for a shadow.
int surface_phase(int phase)
{
    return phase == SHADOWING ? HIT : NORMAL_TAP;
}

// The probe after the distance d at probe_point; a probe that is done stays as it is. Flags are 0 or 1: plain selections,
// which the CPU's vectoriser takes.
Probe advance(Probe probe, float d, March march)
{
    int going = probe.phase < HIT ? 1 : 0;
    int walking = probe.phase <= MARCHING ? 1 : 0;
    int steps = probe.steps + walking;
    float t_next = probe.t + max(d, march.minimum_step);

    int hit = d < march.tolerance ? walking : 0;
    int missed = t_next >= probe.t_end ? walking - hit : 0;
    int stopped = steps >= march.step_limit ? walking - hit - missed : 0;
    int surface = march.out_of_steps_hits != 0 ? hit + stopped : hit;

    int tapped = march.occlusion_strength > 0.0f || probe.phase + 1 != OCCLUSION_TAP ? probe.phase + 1 : HIT;
    int walked = missed + stopped > 0 ? MISSED : probe.phase;
    walked = surface > 0 ? surface_phase(probe.phase) : walked;
    int phase = walking > 0 ? walked : min(tapped, HIT);

    int spent = probe.budget <= 1 ? going : 0;
    spent = phase < HIT ? spent : 0;
    int spent_phase = march.out_of_steps_hits != 0 ? HIT : MISSED;
    spent_phase = hit + 1 - walking > 0 ? HIT : spent_phase;
    phase = spent > 0 ? spent_phase : phase;

    float t_walked = missed + stopped > 0 ? probe.t : t_next;
    t_walked = hit > 0 ? probe.t + clamp(d, -march.minimum_step, 0.0f) : t_walked;

    float tap_weight = probe.phase >= NORMAL_TAP ? 1.0f : 0.0f;
    tap_weight = probe.phase >= OCCLUSION_TAP ? 0.0f : tap_weight;
    float slope = tap_weight * d / (4.0f * tap_size(probe));
    float height = occlusion_height(probe, march) * clamp(length(probe.gradient), 0.1f, 1.0f);
    float blocked = 0.2f * march.occlusion_strength * (1.0f - clamp(d / max(height, 1.0e-6f), 0.0f, 1.0f));
    blocked = probe.phase >= OCCLUSION_TAP ? blocked : 0.0f;

    Probe next = probe;
    next.t = walking > 0 ? t_walked : probe.t;
    next.phase = going > 0 ? phase : probe.phase;
    next.steps = steps;
    next.budget = probe.budget - going;
    next.exhausted = max(probe.exhausted, max(stopped, spent));
    next.gradient = probe.gradient + slope * tap_corner(probe.phase);
    next.openness = probe.openness - float(going) * blocked;
    return next;
}
