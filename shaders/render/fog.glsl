// Fog: air that takes light away on its way and adds its own, by the law of Beer and Lambert.

// density: per metre at y = 0. start: metres from the eye without fog. height_falloff: per metre of height, by which the
// density falls as exp(-height_falloff * y).
struct Fog {
    vec3 colour;
    float density;
    float start;
    float height_falloff;
};

// Integral of exp(-x) from 0 to x, over x.
float fog_mean(float x)
{
    float size = abs(x) < 1.0e-3f ? 1.0e-3f : x;
    return abs(x) < 1.0e-3f ? 1.0f - 0.5f * x : (1.0f - exp(-size)) / size;
}

// The share of light that comes through from the distance t along a ray whose origin is `way` metres from the eye.
float fog_transmittance(Fog fog, vec3 origin, vec3 direction, float way, float t)
{
    float from = clamp(fog.start - way, 0.0f, t);
    float base = clamp(fog.height_falloff * (origin.y + from * direction.y), -20.0f, 80.0f);
    float slope = clamp(fog.height_falloff * direction.y * (t - from), -20.0f, 80.0f);
    return exp(-fog.density * (t - from) * exp(-base) * fog_mean(slope));
}
