// Image: The dark, bright or opaque part of a picture file. Its edge runs between the pixels, where they cross the level.
// field: bound
// synonyms: picture, photo, bitmap, logo, stencil, trace, png, jpeg, drawing from a file

// Stands for a picture while none is chosen: a frame and a sun.
float image_placeholder(vec2 p, float height)
{
    vec2 beyond = abs(p) - vec2(0.65f * height, 0.5f * height);
    float box = length(max(beyond, vec2(0.0f))) + min(max(beyond.x, beyond.y), 0.0f);
    float frame = abs(box + 0.04f * height) - 0.04f * height;
    return min(frame, length(p - vec2(0.25f * height, 0.12f * height)) - 0.16f * height);
}

// What graph/image_request.h says of the list.
float image_sample(List picture, int index)
{
    vec4 four = list_at(picture, 2 + index / 4);
    int lane = index % 4;
    return lane < 2 ? (lane == 0 ? four.x : four.y) : (lane == 2 ? four.z : four.w);
}

// Inside the grid of samples, between them. Outside, by Pythagoras: what is nearest lies beyond the nearest point of
// the grid, so the angle there is a right one or wider; nor is it nearer than the part's box.
float image_between(vec2 at, List picture, vec4 head)
{
    vec2 last = vec2(head.x - 1.0f, head.y - 1.0f);
    vec2 held = clamp(at, vec2(0.0f), last);
    vec2 cell = min(floor(held), last - vec2(1.0f));
    vec2 share = held - cell;
    int columns = int(head.x);
    int first = int(cell.y) * columns + int(cell.x);
    float low = mix(image_sample(picture, first), image_sample(picture, first + 1), share.x);
    float high = mix(image_sample(picture, first + columns), image_sample(picture, first + columns + 1), share.x);
    float inside = mix(low, high, share.y);
    vec2 away = at - held;
    float outside = max(inside, 0.0f);
    vec4 part = list_at(picture, 1);
    vec2 beyond = max(abs(at - vec2(part.x, part.y)) - vec2(part.z, part.w), vec2(0.0f));
    float far = max(sqrt(dot(away, away) + outside * outside), length(beyond));
    return dot(away, away) > 0.0f ? far : inside;
}

float image_distance(
    vec2 p,
    List picture,  // image  The file: PNG, JPEG, HDR, EXR or TIFF. Without one, a frame stands for it.
    int part,      // dark {dark, bright, opaque, transparent}  Which pixels are inside.
    int level,     // 50 [1, 99] %  Brightness at the edge, or opacity where the part is opaque or transparent.
    int detail,    // 256 [16, 500]  How many samples the longer side gets. Exports need few.
    float height)  // 1.5 [0.001, 1000] [0.1, 10] m  Height of the whole picture.
{
    float result = 0.0f;
    if (picture.count > 0) {
        vec4 head = list_at(picture, 0);
        float spacing = height * head.w;
        vec2 middle = vec2(0.5f * (head.x - 1.0f), 0.5f * (head.y - 1.0f));
        result = spacing * image_between(p / spacing + middle, picture, head);
    } else {
        result = image_placeholder(p, height);
    }
    return result;
}

Box image_bounds(List picture, float height)
{
    Box box = make_box(vec3(0.0f), vec3(0.65f * height, 0.5f * height, 0.0f));
    if (picture.count > 0) {
        vec4 head = list_at(picture, 0);
        vec4 part = list_at(picture, 1);
        float spacing = height * head.w;
        vec3 middle = vec3(part.x - 0.5f * (head.x - 1.0f), part.y - 0.5f * (head.y - 1.0f), 0.0f);
        box = make_box(middle * spacing, vec3(part.z, part.w, 0.0f) * spacing);
    }
    return box;
}

float image_lipschitz(List picture) { return picture.count > 0 ? list_at(picture, 0).z : 1.0f; }
