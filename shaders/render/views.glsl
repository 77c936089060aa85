// Views: buffers as colours, in linear Rec.709, and the sRGB encoding at the end.

float srgb_encode_channel(float x)
{
    float c = clamp(x, 0.0f, 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * pow(max(c, 0.0031308f), 1.0f / 2.4f) - 0.055f;
}

float srgb_decode_channel(float x)
{
    float c = clamp(x, 0.0f, 1.0f);
    return c <= 0.04045f ? c / 12.92f : pow((max(c, 0.04045f) + 0.055f) / 1.055f, 2.4f);
}

vec3 srgb_encode(vec3 colour)
{
    return vec3(srgb_encode_channel(colour.r), srgb_encode_channel(colour.g), srgb_encode_channel(colour.b));
}

vec3 srgb_decode(vec3 colour)
{
    return vec3(srgb_decode_channel(colour.r), srgb_decode_channel(colour.g), srgb_decode_channel(colour.b));
}

vec3 view_beauty(vec3 colour)
{
    return clamp(colour, vec3(0.0f), vec3(1.0f));
}

// Half the world-space normal plus a half, as stored (encoded) values; black where nothing was hit.
vec3 view_normal(vec3 normal)
{
    return dot(normal, normal) > 0.25f ? srgb_decode(vec3(0.5f) + 0.5f * normal) : vec3(0.0f);
}

// White at the eye, mid grey at 5 m; a negative depth is a miss, and black.
vec3 view_depth(float depth)
{
    return depth < 0.0f ? vec3(0.0f) : vec3(5.0f / (5.0f + depth));
}

// A colour that is no light, as it is.
vec3 view_plain(vec3 colour)
{
    return clamp(colour, vec3(0.0f), vec3(1.0f));
}

// A share from 0 to 1 as grey, as stored (encoded) values.
vec3 view_share(float share)
{
    return srgb_decode(vec3(share));
}

// Metres along x, y and z as red, green and blue, as stored (encoded) values: each begins anew in every metre.
vec3 view_position(vec3 position)
{
    return srgb_decode(fract(position));
}

// One channel of a hue, 0 to 1 around the circle.
float hue_channel(float hue, float phase)
{
    float x = fract(hue + phase);
    return clamp(abs(6.0f * x - 3.0f) - 1.0f, 0.0f, 1.0f);
}

// A colour per id: neighbours in number are far apart in hue (golden ratio), and every third differs in lightness.
// Id 0 is black.
vec3 view_id(int id)
{
    float x = float(id);
    float hue = fract(0.61803399f * x);
    float lightness = 0.9f - 0.2f * (x - 3.0f * floor(x / 3.0f));
    vec3 pure = vec3(hue_channel(hue, 0.0f), hue_channel(hue, 0.66666667f), hue_channel(hue, 0.33333333f));
    return id == 0 ? vec3(0.0f) : lightness * mix(vec3(1.0f), pure, 0.7f);
}
