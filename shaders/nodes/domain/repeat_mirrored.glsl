// Repeat mirrored: Fills space with copies of a solid, every second one mirrored, so that neighbours meet.
// What leaves its cell is cut there. Quicker than repeating, and exact for symmetric solids that stay in their cell.
// field: bound
// synonyms: tile, ping-pong, reflect, infinite, seamless, wallpaper
float repeat_mirrored_fold(float x, float pitch)
{
    float safe = max(pitch, 1.0e-6f);
    float index = floor(x / safe + 0.5f);
    float inside = x - index * safe;
    bool odd = index - 2.0f * floor(0.5f * index) > 0.5f;
    float folded = odd ? -inside : inside;
    return pitch > 0.0f ? folded : x;
}

vec3 repeat_mirrored_point(
    vec3 p,
    vec3 spacing)  // (1.5, 0, 1.5) [0, 1000] [0, 5] m  Size of a cell along x, y and z; 0 does not repeat.
{
    float x = repeat_mirrored_fold(p.x, spacing.x);
    float z = repeat_mirrored_fold(p.z, spacing.z);
    return vec3(x, repeat_mirrored_fold(p.y, spacing.y), z);
}

Box repeat_mirrored_bounds(vec3 spacing, Box child)
{
    vec3 centre = vec3(spacing.x > 0.0f ? 0.0f : child.centre.x, spacing.y > 0.0f ? 0.0f : child.centre.y,
                       spacing.z > 0.0f ? 0.0f : child.centre.z);
    vec3 half_size = vec3(spacing.x > 0.0f ? UNBOUNDED : child.half_size.x,
                          spacing.y > 0.0f ? UNBOUNDED : child.half_size.y,
                          spacing.z > 0.0f ? UNBOUNDED : child.half_size.z);
    return make_box(centre, half_size);
}
