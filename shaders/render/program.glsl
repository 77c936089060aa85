// Program: the calls that lowering inserts between the nodes' own.

// Divides a Lipschitz constant out, so that a step by the result never overshoots.
float divide_distance(float d, float lipschitz)
{
    return d / max(lipschitz, 1.0f);
}

float multiply_lipschitz(float a, float b)
{
    return a * b;
}

float larger_lipschitz(float a, float b)
{
    return max(a, b);
}

Material default_material()
{
    return make_material(vec3(0.62f, 0.62f, 0.62f), vec3(0.04f, 0.04f, 0.04f), 32.0f, vec3(0.0f));
}

// Weight 0 is all a, 1 is all b.
Material mix_material(Material a, Material b, float weight)
{
    Material material;
    material.albedo = mix(a.albedo, b.albedo, weight);
    material.specular = mix(a.specular, b.specular, weight);
    material.shininess = mix(a.shininess, b.shininess, weight);
    material.emission = mix(a.emission, b.emission, weight);
#if MICROFACETS
    material.roughness = mix(a.roughness, b.roughness, weight);
    material.microfacet = mix(a.microfacet, b.microfacet, weight);
#endif
#if REFLECTION
    material.reflection = mix(a.reflection, b.reflection, weight);
    material.transmission = mix(a.transmission, b.transmission, weight);
    material.refraction_index = mix(a.refraction_index, b.refraction_index, weight);
    material.absorption = mix(a.absorption, b.absorption, weight);
#endif
#if TINTED_SHADOWS
    material.shadow = mix(a.shadow, b.shadow, weight);
#endif
    return material;
}

// Ids are floats, exact up to 2^24: this selection is one operation, where one between ints compiles as a branch.
float choose_id(float a, float b, bool b_shows)
{
    return mix(a, b, b_shows);
}

// Whether b's id shows, for combiners that do not say so themselves.
bool mostly_b(float weight)
{
    return weight >= 0.5f;
}

vec2 splat_vec2(float x)
{
    return vec2(x, x);
}

vec3 splat_vec3(float x)
{
    return vec3(x, x, x);
}

vec3 way_between(vec3 from, vec3 to)
{
    return to - from;
}

// Where a chain of affine nodes takes a point that takes the origin and the unit vectors there.
vec3 moved_point(vec3 p, vec3 origin, vec3 x, vec3 y, vec3 z)
{
    return origin + p.x * x + p.y * y + p.z * z;
}

// A 2D field shown on its own: its plane is z = 0.
vec2 plane_point(vec3 p)
{
    return vec2(p.x, p.y);
}

vec3 lift_point(vec2 p)
{
    return vec3(p.x, p.y, 0.0f);
}

// Nothing is anywhere near: the field of an empty scene.
float nothing_distance(vec3 p)
{
    return UNBOUNDED;
}

// The share of a block's new copy: the nearer one shows.
float nearest_blend(float acc, float d)
{
    return d < acc ? 1.0f : 0.0f;
}

bool nearest_shows(float acc, float d)
{
    return d < acc;
}

// Sky of a scene without one.
vec3 empty_sky(vec3 direction, float spread)
{
    return vec3(0.05f);
}

float clamp_number(float x, float low, float high)
{
    return clamp(x, low, high);
}

vec2 clamp_vec2(vec2 x, float low, float high)
{
    return clamp(x, vec2(low, low), vec2(high, high));
}

vec3 clamp_vec3(vec3 x, float low, float high)
{
    return clamp(x, vec3(low, low, low), vec3(high, high, high));
}
