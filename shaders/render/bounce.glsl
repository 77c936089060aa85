// Bounce: the rays that mirrors and glass send on. A hit has two children, the mirrored ray and the refracted one; their
// weights, and those of all further ones, add up to no more than its own.

// Below it nobody sees a ray: 1/255.
const float BOUNCE_CUTOFF = 0.004f;
// Inside a solid, rays march by |d| = -d; a little less than that, or rounding carries them past the surface.
const float INSIDE_STEPS = 0.99f;

// start: where along the ray the march begins. side: the factor on distances, 1 outside and -INSIDE_STEPS inside a solid,
// of which absorption is (per metre). way: metres from the eye to the origin. depth: bounces so far.
struct Bounce {
    vec3 origin;
    vec3 direction;
    float start;
    vec3 weight;
    vec3 absorption;
    float side;
    float way;
    int depth;
};

// Where the light of a hit comes from: shares, and the direction behind the surface. Together with what scatters they
// add up to 1.
struct Split {
    vec3 mirrored;
    vec3 refracted;
    vec3 direction;
};

Bounce eye_bounce(Ray ray, March march)
{
    Bounce bounce;
    bounce.origin = ray.origin;
    bounce.direction = ray.direction;
    bounce.start = march.near_limit;
    bounce.weight = vec3(1.0f);
    bounce.absorption = vec3(0.0f);
    bounce.side = 1.0f;
    bounce.way = 0.0f;
    bounce.depth = 0;
    return bounce;
}

// Beyond the last bounce a ray sees the sky at once. overhead: what a ray costs beside its steps, in distances.
Probe bounce_probe(Bounce bounce, March march, int budget, int bounces, int overhead)
{
    bool from_eye = bounce.depth == 0;
    int phase = bounce.depth > bounces ? MISSED : MARCHING;
    int left = from_eye ? budget : max(budget - overhead, 0);
    return make_probe(bounce.origin, bounce.direction, bounce.start, march.far_limit, phase, left);
}

// Schlick's approximation of Fresnel's equations, with the exponent 5. What mirrors less than 2 % straight on mirrors
// less than all at grazing angles too, and what mirrors nothing nothing.
vec3 fresnel_share(vec3 reflection, float cosine)
{
    float x = 1.0f - clamp(cosine, 0.0f, 1.0f);
    float squared = x * x;
    vec3 grazing = clamp(50.0f * reflection, vec3(0.0f), vec3(1.0f));
    return mix(reflection, grazing, squared * squared * x);
}

// normal: on the ray's side. Going out of the denser side, Schlick takes the cosine behind the surface; beyond the
// critical angle there is none, and what would go through is mirrored (total internal reflection).
Split split_light(Material material, vec3 normal, vec3 direction, float side)
{
    float index = max(material.refraction_index, 1.0e-3f);
    float ratio = side > 0.0f ? 1.0f / index : index;
    float cosine = clamp(-dot(direction, normal), 0.0f, 1.0f);
    float squared = 1.0f - ratio * ratio * (1.0f - cosine * cosine);
    float cosine_behind = sqrt(max(squared, 0.0f));
    vec3 mirrored = fresnel_share(material.reflection, ratio > 1.0f ? cosine_behind : cosine);
    vec3 through = (vec3(1.0f) - mirrored) * material.transmission;
    float total = squared <= 0.0f ? 1.0f : 0.0f;
    Split split;
    split.mirrored = mirrored + total * through;
    split.refracted = (1.0f - total) * through;
    split.direction = ratio * direction + (ratio * cosine - cosine_behind) * normal;
    return split;
}

// The material of what is neither mirrored nor refracted.
Material scattering_material(Material material, Split split)
{
    Material result = material;
    result.albedo = material.albedo * max(vec3(1.0f) - split.mirrored - split.refracted, vec3(0.0f));
    return result;
}

// The material of one look at the sky: what the mirrored ray brings is no part of it.
Material ambient_material(Material material)
{
    Material result = material;
    result.specular = max(material.specular - material.reflection, vec3(0.0f));
    return result;
}

// What is left of the light that comes along a ray from the distance t.
vec3 bounce_weight(Bounce bounce, float t)
{
    return bounce.weight * exp(-bounce.absorption * t);
}

bool bounce_shows(Bounce bounce)
{
    return max(bounce.weight.x, max(bounce.weight.y, bounce.weight.z)) > BOUNCE_CUTOFF;
}

// Off the surface by more than the marcher may have stepped into it.
float bounce_offset(March march)
{
    return 4.0f * march.tolerance + 2.0f * march.minimum_step;
}

// From the hit at the distance t. weight: bounce_weight there.
Bounce mirrored_bounce(Bounce bounce, Split split, vec3 weight, vec3 position, vec3 normal, float t, March march)
{
    Bounce next = bounce;
    next.origin = position + bounce_offset(march) * normal;
    next.direction = bounce.direction - 2.0f * dot(bounce.direction, normal) * normal;
    next.start = 0.0f;
    next.weight = weight * split.mirrored;
    next.way = bounce.way + t;
    next.depth = bounce.depth + 1;
    return next;
}

// Into the solid, or out of it. Begins off the surface, but on the line from the hit, or all would be shifted; only the
// flattest rays are.
Bounce refracted_bounce(Bounce bounce, Split split, vec3 weight, Material material, vec3 position, vec3 normal, float t,
                        March march)
{
    bool enters = bounce.side > 0.0f;
    float offset = bounce_offset(march);
    Bounce next = bounce;
    next.direction = split.direction / max(length(split.direction), 1.0e-6f);
    float cosine = -dot(next.direction, normal);
    next.start = offset / max(cosine, 0.1f);
    next.origin = position - (offset - next.start * cosine) * normal;
    next.weight = weight * split.refracted;
    next.absorption = enters ? material.absorption : vec3(0.0f);
    next.side = enters ? -INSIDE_STEPS : 1.0f;
    next.way = bounce.way + t;
    next.depth = bounce.depth + 1;
    return next;
}
