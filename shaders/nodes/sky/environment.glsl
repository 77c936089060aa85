// Environment: A picture of everything around, wrapped over the sky: it is seen behind the scene and lights it.
// synonyms: hdri, hdr, panorama, equirectangular, image sky, dome, skybox, background, environment map

// Stands for a picture while none is chosen: an overcast day.
vec3 environment_placeholder(vec3 direction, float spread)
{
    vec3 sky = mix(vec3(0.75f, 0.78f, 0.80f), vec3(0.42f, 0.52f, 0.66f), clamp(direction.y, 0.0f, 1.0f));
    return mix(sky, vec3(0.22f, 0.21f, 0.20f), smoothstep(-0.6f * spread, 0.02f + 0.6f * spread, -direction.y));
}

vec3 environment_texel(List picture, int first, int columns, int column, int row)
{
    vec4 texel = list_at(picture, first + row * columns + column);
    return vec3(texel.x, texel.y, texel.z);
}

// Between the middles of four texels of a map that begins at `first`; around the poles the outermost row goes on.
vec3 environment_look(List picture, int first, vec2 size, vec2 at)
{
    float x = at.x * size.x - 0.5f;
    float y = clamp(at.y * size.y - 0.5f, 0.0f, size.y - 1.0f);
    float left = floor(x);
    float top = min(floor(y), size.y - 2.0f);
    int columns = int(size.x);
    int column = int(mod(left, size.x));
    int next = int(mod(left + 1.0f, size.x));
    int row = int(top);
    vec3 above = mix(environment_texel(picture, first, columns, column, row),
                     environment_texel(picture, first, columns, next, row), x - left);
    vec3 below = mix(environment_texel(picture, first, columns, column, row + 1),
                     environment_texel(picture, first, columns, next, row + 1), x - left);
    return mix(above, below, y - top);
}

// graph/image_request.h says what the list holds. Looks between a mirror's and a matt surface's mix the two maps.
vec3 environment_sky(
    vec3 direction,
    float spread,
    List picture,    // image  The file: HDR, EXR, PNG, JPEG or TIFF, twice as wide as high, with the horizon in its middle. Without one, a grey day stands for it.
    int detail,      // 360 [16, 1024]  How many pixels of the picture are kept around the horizon. Exports need few.
    float turn,      // 0.0 [-360, 360] [-180, 180] deg  Turn around y. At 0 the middle of the picture lies at -z, ahead of an unturned camera.
    float strength)  // 1.0 [0, 1000] [0, 5]  Brightness of the picture.
{
    vec3 result = environment_placeholder(direction, spread);
    if (picture.count > 0) {
        vec4 head = list_at(picture, 0);
        float level = max(length(vec2(direction.x, direction.z)), 1.0e-6f);
        float around = level > 2.0e-6f ? atan(direction.x, -direction.z) - turn : -turn;
        float down = atan(level, direction.y);
        vec2 at = vec2(fract(0.5f + around * 0.159154943f), down * 0.318309886f);
        int sharp_count = int(head.x) * int(head.y);
        vec3 wide = environment_look(picture, 1 + sharp_count, vec2(head.z, head.w), at);
        vec3 sharp = environment_look(picture, 1, vec2(head.x, head.y), at);
        result = mix(sharp, wide, spread);
    }
    return strength * result;
}
