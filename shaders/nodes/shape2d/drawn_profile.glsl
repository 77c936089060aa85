// Drawn profile: A flat shape painted cell by cell on a square canvas.
// The cells are kept as few rectangles; at most 512 are drawn, those of the gaps around them included.
// field: exact
// synonyms: pixel canvas, pixel art, bitmap, drawing, sketch, silhouette, stencil
float drawn_profile_distance(
    vec2 p,
    List rectangles,  // [(11, 8, 5, 1), (1, 8, 1, 2), (4, 11.5, 2, 0.5), (10, 6, 1, 1), (14, 6, 1, 1), (4, 4.5, 2, 0.5), (2, 10.5, 1, 0.5), (6, 10.5, 1, 0.5), (7, 9.5, 1, 0.5), (7, 6.5, 1, 0.5), (2, 5.5, 1, 0.5), (6, 5.5, 1, 0.5)] [-64, 64] cells  The painted cells: centre, half width and half height of rectangles, from the lower left corner.
    int cells,        // 16 [1, 64] [4, 64]  Cells along each side of the canvas.
    float size)       // 1.0 [0.001, 200] [0.05, 5] m  Length of a side of the canvas.
{
    float cell_size = size / float(cells);
    vec2 at = p / cell_size + vec2(0.5f * float(cells));
    float outside = 1.0e12f;
    float inside = 1.0e12f;
    float depth = 0.0f;
    for (int i = 0; i < 512; i++) {
        if (i >= rectangles.count) {
            break;
        }
        vec4 rectangle = list_at(rectangles, i);
        float x = abs(at.x - rectangle.x) - abs(rectangle.z);
        float y = abs(at.y - rectangle.y) - abs(rectangle.w);
        float squared = max(x, 0.0f) * max(x, 0.0f) + max(y, 0.0f) * max(y, 0.0f);
        // A gap has a negative half width.
        outside = min(outside, rectangle.z < 0.0f ? 1.0e12f : squared);
        inside = min(inside, rectangle.z < 0.0f ? squared : 1.0e12f);
        depth = max(depth, rectangle.z < 0.0f ? 0.0f : -max(x, y));
    }
    // Where the gaps were too many to be listed, the depth in one rectangle is a bound.
    float to_shape = sqrt(outside);
    float to_gap = inside < 1.0e11f ? sqrt(inside) : depth;
    // No point lies outside of both, but for rounding where rectangles touch: there the depth counts.
    float nearest = to_shape - max(to_gap - to_shape, 0.0f);
    return rectangles.count > 0 ? nearest * cell_size : UNBOUNDED;
}

Box drawn_profile_bounds(List rectangles, int cells, float size)
{
    vec2 low = vec2(UNBOUNDED);
    vec2 high = vec2(-UNBOUNDED);
    for (int i = 0; i < 512; i++) {
        if (i >= rectangles.count) {
            break;
        }
        vec4 rectangle = list_at(rectangles, i);
        if (rectangle.z >= 0.0f) {
            low = min(low, vec2(rectangle.x - rectangle.z, rectangle.y - abs(rectangle.w)));
            high = max(high, vec2(rectangle.x + rectangle.z, rectangle.y + abs(rectangle.w)));
        }
    }
    high = max(high, low);
    vec2 centre = rectangles.count > 0 ? 0.5f * (low + high) - vec2(0.5f * float(cells)) : vec2(0.0f);
    vec2 reach = 0.5f * (high - low);
    float cell_size = size / float(cells);
    return make_box(vec3(centre.x * cell_size, centre.y * cell_size, 0.0f),
                    vec3(reach.x * cell_size, reach.y * cell_size, 0.0f));
}
