// Tinted shadow: a shadow ray that goes on through glass, straight on, and is dimmer behind every surface.

// How many surfaces light may come through or close by on its way; the next one stops it.
const int BEAM_CROSSINGS = 16;

// What a shadow ray knows beside its probe. tint: what is left of the light. side: the factor on distances, as a bounce's.
// absorption: per metre, of the solid that it is in since the distance `entered`. edge: what comes past the things that
// soften the shadow.
struct Beam {
    vec3 tint;
    float side;
    vec3 absorption;
    float entered;
    vec3 edge;
};

Beam make_beam()
{
    Beam beam;
    beam.tint = vec3(1.0f);
    beam.side = 1.0f;
    beam.absorption = vec3(0.0f);
    beam.entered = 0.0f;
    beam.edge = vec3(1.0f);
    return beam;
}

// Shadow rays do not ask how open what they hit is.
March shadow_march(March march)
{
    March result = march;
    result.occlusion_strength = 0.0f;
    return result;
}

// What one surface lets through, seen under that cosine from outside: since the ray stays straight, it leaves a solid
// under the angle that it would have outside.
vec3 surface_tint(Material material, float cosine)
{
    vec3 through = material.transmission * (vec3(1.0f) - fresnel_share(material.reflection, cosine));
    vec3 dimmed = clamp(material.shadow, 0.0f, 1.0f) * through;
    return mix(dimmed, vec3(1.0f), clamp(material.shadow - 1.0f, 0.0f, 1.0f));
}

// Whether what the ray came to last is nearer, by the way to it, than all that it has passed before.
bool last_is_nearest(Probe probe)
{
    return probe.last_ratio >= 0.0f && probe.last_ratio < probe.cone_ratio;
}

// The light that comes past the nearest of them, if it is opaque.
float edge_light(Probe probe, Light light, int shadow)
{
    float open = clamp(light.sharpness * (last_is_nearest(probe) ? probe.last_ratio : probe.cone_ratio), 0.0f, 1.0f);
    return shadow == HARD_SHADOW ? 1.0f : open * open * (3.0f - 2.0f * open);
}

// A probe that began on a side that faces away, or gave up, met no surface.
bool met_surface(Probe probe)
{
    return probe.phase == HIT && probe.steps > 0 && probe.exhausted == 0;
}

// Whether the leg that is done needs to know a material: of what stopped it, or of the nearest thing that it passed.
bool beam_asks(Probe probe, Light light, int shadow)
{
    bool grazed = probe.phase == MISSED && edge_light(probe, light, shadow) < 1.0f;
    return grazed || met_surface(probe);
}

// Where.
vec3 beam_point(Probe probe)
{
    float nearest = last_is_nearest(probe) ? probe.t : probe.nearest;
    return probe.origin + (probe.phase == MISSED ? nearest : probe.t) * probe.direction;
}

float beam_cosine(Probe probe)
{
    return abs(dot(probe.direction, probe_normal(probe)));
}

// Behind the surface of that material where the leg ended; or, where it met none, knowing whom it passed. Of several things that
// soften a shadow the one that dims the most counts.
Beam beam_behind(Beam beam, Probe probe, Material material, Light light, int shadow)
{
    bool crosses = probe.phase == HIT;
    bool enters = beam.side > 0.0f;
    vec3 kept = exp(-beam.absorption * max(probe.t - beam.entered, 0.0f));
    vec3 straight = surface_tint(material, 1.0f);
    vec3 edge = mix(straight * straight, vec3(1.0f), edge_light(probe, light, shadow));
    Beam next = beam;
    next.tint = beam.tint * (crosses ? kept * surface_tint(material, beam_cosine(probe)) : vec3(1.0f));
    next.side = crosses && enters ? -INSIDE_STEPS : 1.0f;
    next.side = crosses ? next.side : beam.side;
    vec3 absorption = clamp(2.0f - material.shadow, 0.0f, 1.0f) * material.absorption;
    absorption = enters ? absorption : vec3(0.0f);
    next.absorption = crosses ? absorption : beam.absorption;
    next.entered = crosses ? probe.t : beam.entered;
    next.edge = crosses ? beam.edge : min(beam.edge, edge);
    return next;
}

// The ray without the nearest thing that it passed.
Probe without_nearest(Probe probe)
{
    bool is_last = last_is_nearest(probe);
    Probe next = probe;
    next.cone_ratio = is_last ? probe.cone_ratio : probe.second_ratio;
    next.nearest = is_last ? probe.nearest : probe.second_nearest;
    next.second_ratio = is_last ? probe.second_ratio : UNBOUNDED;
    next.last_ratio = is_last ? UNBOUNDED : probe.last_ratio;
    return next;
}

// The next leg behind a surface, by as much off it as a bounce begins. Inside a solid a ray passes nothing, and out of it not
// what it leaves.
Probe leg_behind(Probe probe, Beam beam, int shadow, March march)
{
    float t = probe.t + bounce_offset(march) / max(beam_cosine(probe), 0.1f);
    int phase = beam.side < 0.0f ? -HARD_SHADOW : -shadow;
    Probe next = probe;
    next.t = t;
    next.phase = t < probe.t_end ? phase : MISSED;
    next.gradient = vec3(0.0f);
    next.stride = UNBOUNDED;
    next.last_ratio = -1.0e-9f;
    return next;
}

// After beam_behind: stopped where no light is left, else the next leg, or the next thing to ask for.
Probe next_leg(Probe probe, Beam beam, int shadow, March march)
{
    float shows = max(beam.tint.x, max(beam.tint.y, beam.tint.z));
    Probe behind = leg_behind(probe, beam, shadow, march);
    Probe fewer = without_nearest(probe);
    bool goes_on = probe.phase == HIT && shows > BOUNCE_CUTOFF;
    bool missed = probe.phase == MISSED;
    Probe next = probe;
    next.t = goes_on ? behind.t : probe.t;
    next.phase = goes_on ? behind.phase : probe.phase;
    next.gradient = goes_on ? behind.gradient : probe.gradient;
    next.stride = goes_on ? behind.stride : probe.stride;
    next.cone_ratio = missed ? fewer.cone_ratio : probe.cone_ratio;
    next.nearest = missed ? fewer.nearest : probe.nearest;
    next.second_ratio = missed ? fewer.second_ratio : probe.second_ratio;
    next.last_ratio = missed ? fewer.last_ratio : (goes_on ? behind.last_ratio : probe.last_ratio);
    return next;
}

bool beam_stopped(Probe probe)
{
    return probe.phase == HIT;
}

// What is left of the light once all legs are done.
vec3 beam_visibility(Beam beam, Probe probe)
{
    vec3 kept = exp(-beam.absorption * max(probe.t_end - beam.entered, 0.0f));
    vec3 tint = beam.side < 0.0f ? beam.tint * kept : beam.tint;
    return probe.phase == MISSED ? tint * beam.edge : vec3(0.0f);
}

// By the weights of Rec.709.
float brightness(vec3 tint)
{
    return dot(tint, vec3(0.2126f, 0.7152f, 0.0722f));
}
