// Tone map: scene light to what a screen shows, both linear Rec.709.

vec3 expose(vec3 colour, float stops)
{
    return colour * exp2(stops);
}

vec3 tone_map_none(vec3 colour)
{
    return colour;
}

// Khronos PBR Neutral (specification of 2024): base colours stay as they are; highlights are compressed, then bleached.
vec3 tone_map_neutral(vec3 colour)
{
    vec3 light = max(colour, vec3(0.0f));
    float least = min(light.r, min(light.g, light.b));
    float fresnel = least < 0.08f ? least - 6.25f * least * least : 0.04f;
    vec3 base = light - vec3(fresnel);
    float peak = max(base.r, max(base.g, base.b));
    float room = 0.24f;
    float compressed = 1.0f - room * room / max(peak + room - 0.76f, 0.24f);
    float bleached = 1.0f - 1.0f / (0.15f * max(peak - compressed, 0.0f) + 1.0f);
    vec3 bright = mix(base * (compressed / max(peak, 1.0e-6f)), vec3(compressed), bleached);
    return peak < 0.76f ? base : bright;
}

// AgX's base contrast as a polynomial of degree 6 (B. Wrensch, "Minimal AgX implementation", 2023).
float agx_contrast(float x)
{
    float y = 15.5f * x - 40.14f;
    y = y * x + 31.96f;
    y = y * x - 6.868f;
    y = y * x + 0.4298f;
    y = y * x + 0.1191f;
    return y * x - 0.00232f;
}

float agx_encode(float x)
{
    float stops = log2(max(x, 1.0e-10f));
    return clamp((stops + 12.47393f) / 16.500000f, 0.0f, 1.0f);
}

// AgX (T. Sobotka, 2022): bright colours turn towards white as on film.
vec3 tone_map_agx(vec3 colour)
{
    vec3 light = max(colour, vec3(0.0f));
    float r = dot(vec3(0.842479f, 0.0784336f, 0.0792237f), light);
    float g = dot(vec3(0.0423283f, 0.878469f, 0.0791661f), light);
    float b = dot(vec3(0.0423757f, 0.0784336f, 0.879143f), light);
    vec3 shown = vec3(agx_contrast(agx_encode(r)), agx_contrast(agx_encode(g)), agx_contrast(agx_encode(b)));
    float red = dot(vec3(1.19687901f, -0.09802088f, -0.09902974f), shown);
    float green = dot(vec3(-0.05289685f, 1.15190313f, -0.09896118f), shown);
    float blue = dot(vec3(-0.05297163f, -0.09804345f, 1.15107367f), shown);
    vec3 encoded = max(vec3(red, green, blue), vec3(1.0e-6f));
    return vec3(pow(encoded.r, 2.2f), pow(encoded.g, 2.2f), pow(encoded.b, 2.2f));
}

float aces_curve(float x)
{
    return (x * (x + 0.0245786f) - 0.000090537f) / (x * (0.983729f * x + 0.4329510f) + 0.238081f);
}

// The ACES reference rendering and output transforms as fitted by S. Hill (2016), without the brighter exposure that some
// engines add.
vec3 tone_map_aces(vec3 colour)
{
    vec3 light = max(colour, vec3(0.0f));
    float r = aces_curve(dot(vec3(0.59719f, 0.35458f, 0.04823f), light));
    float g = aces_curve(dot(vec3(0.07600f, 0.90834f, 0.01566f), light));
    float b = aces_curve(dot(vec3(0.02840f, 0.13383f, 0.83777f), light));
    float red = dot(vec3(1.60475f, -0.53108f, -0.07367f), vec3(r, g, b));
    float green = dot(vec3(-0.10208f, 1.10813f, -0.00605f), vec3(r, g, b));
    float blue = dot(vec3(-0.00327f, -0.07276f, 1.07602f), vec3(r, g, b));
    return max(vec3(red, green, blue), vec3(0.0f));
}
