// Text: Letters of a font as a flat shape.
// Their outlines are saved in the scene, so that it looks the same where the font is missing.
// Curves are followed within a thousandth of the size, in long texts within a hundredth; at most 512 sides are drawn.
// field: exact
// synonyms: letters, lettering, font, type, typography, words, label, caption
// text text: "HI"  What is written; Return begins a new line.
// text font: ""  Family of an installed font or path of a font file; left empty it is Inter, which is always there.
// number letter_spacing: 0.0 [-1, 10] [-0.2, 1] em  Space between letters beyond what the font asks for.
// number line_spacing: 1.0 [0, 10] [0.5, 3]  Way from line to line, as a multiple of the font's own.
// number alignment: 0.5 [0, 1]  Where lines of different length meet: 0 at the left, 0.5 in the middle, 1 at the right.
float text_distance(
    vec2 p,
    List outlines,  // [(-0.414062, -0.36364, 1), (-0.325996, -0.36364), (-0.325996, -0.038353), (0.0617905, -0.038353), (0.0617905, -0.36364), (0.149857, -0.36364), (0.149857, 0.36364), (0.0617905, 0.36364), (0.0617905, 0.039772), (-0.325996, 0.039772), (-0.325996, 0.36364), (-0.414062, 0.36364), (0.325996, -0.36364, 1), (0.414062, -0.36364), (0.414062, 0.36364), (0.325996, 0.36364)] [-1000, 1000] em  Corners of the letters, remade from the text; a third number of 1 begins an outline.
    float size)     // 1.0 [0.001, 100] [0.05, 5] m  Size of the font, about the height of a line.
{
    vec2 at = p / size;
    float squared = 1.0e12f;
    int crossings = 0;
    for (int i = 0; i < 512; i++) {
        if (i >= outlines.count) {
            break;
        }
        vec4 side = list_at(outlines, i);
        float along_x = side.z - side.x;
        float along_y = side.w - side.y;
        float from_x = at.x - side.x;
        float from_y = at.y - side.y;
        float share = (from_x * along_x + from_y * along_y) / max(along_x * along_x + along_y * along_y, 1.0e-12f);
        share = clamp(share, 0.0f, 1.0f);
        float away_x = from_x - along_x * share;
        float away_y = from_y - along_y * share;
        squared = min(squared, away_x * away_x + away_y * away_y);
        // A ray to the right crosses the sides that pass its height on that side.
        bool passes = (side.y > at.y) != (side.w > at.y);
        float turn = along_x * from_y - along_y * from_x;
        bool to_the_right = along_y > 0.0f ? turn > 0.0f : turn < 0.0f;
        crossings = crossings + (passes && to_the_right ? 1 : 0);
    }
    float distance_to_side = sqrt(squared) * size;
    bool inside = crossings - 2 * (crossings / 2) == 1;
    return outlines.count == 0 ? UNBOUNDED : inside ? -distance_to_side : distance_to_side;
}

Box text_bounds(List outlines, float size)
{
    vec2 low = vec2(UNBOUNDED);
    vec2 high = vec2(-UNBOUNDED);
    for (int i = 0; i < 512; i++) {
        if (i >= outlines.count) {
            break;
        }
        vec4 side = list_at(outlines, i);
        low = min(low, vec2(side.x, side.y));
        high = max(high, vec2(side.x, side.y));
    }
    high = max(high, low);
    vec2 centre = outlines.count > 0 ? 0.5f * size * (low + high) : vec2(0.0f);
    vec2 reach = 0.5f * size * (high - low);
    return make_box(vec3(centre.x, centre.y, 0.0f), vec3(reach.x, reach.y, 0.0f));
}
