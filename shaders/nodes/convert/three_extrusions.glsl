// Three extrusions: What looks like one drawing from the front, another from the right and a third from above.
// Each flat shape is pulled out along its line of sight without end; what all of them share is left.
// An input that is not wired or switched off is left out.
// field: bound; exact
// synonyms: silhouette, orthographic views, front side top, projection intersection, square triangle circle
// inputs: Front view, Right view, View from above
// combiner: hard
vec2 three_extrusions_point_a(vec3 p)
{
    return vec2(p.x, p.y);
}

// Seen from the right, what lies in front is on the left.
vec2 three_extrusions_point_b(vec3 p)
{
    return vec2(-p.z, p.y);
}

vec2 three_extrusions_point_c(vec3 p)
{
    return vec2(p.x, -p.z);
}

// What is left out is everywhere.
float three_extrusions_kept(float distance_seen, bool shown)
{
    return shown && distance_seen < 0.5f * UNBOUNDED ? distance_seen : -UNBOUNDED;
}

float three_extrusions_distance(
    float a,
    float b,
    float c,
    bool front,  // true  Cut to the shape seen from the front, along -z.
    bool right,  // true  Cut to the shape seen from the right, along -x.
    bool above,  // true  Cut to the shape seen from above, along -y.
    float trim)  // 0.0002 [0, 1] [0, 0.01] m  Taken off all around, so that faces which only touch leave no film.
{
    float overlap = max(three_extrusions_kept(a, front),
                        max(three_extrusions_kept(b, right), three_extrusions_kept(c, above)));
    return overlap <= -0.5f * UNBOUNDED ? UNBOUNDED : overlap + trim;
}

float three_extrusions_blend(float a, float b, bool front, bool right)
{
    return three_extrusions_kept(b, right) > three_extrusions_kept(a, front) ? 1.0f : 0.0f;
}

float three_extrusions_blend_c(float a, float b, float c, bool front, bool right, bool above)
{
    float others = max(three_extrusions_kept(a, front), three_extrusions_kept(b, right));
    return three_extrusions_kept(c, above) > others ? 1.0f : 0.0f;
}

// Along the line of sight a view says nothing.
Box three_extrusions_view(bool shown, vec3 centre, vec3 half_size)
{
    return make_box(shown ? centre : vec3(0.0f), shown ? half_size : vec3(UNBOUNDED));
}

Box three_extrusions_bounds(bool front, bool right, bool above, Box box_a, Box box_b, Box box_c)
{
    Box seen = three_extrusions_view(front, vec3(box_a.centre.x, box_a.centre.y, 0.0f),
                                     vec3(box_a.half_size.x, box_a.half_size.y, UNBOUNDED));
    seen = overlap_boxes(seen, three_extrusions_view(right, vec3(0.0f, box_b.centre.y, -box_b.centre.x),
                                                     vec3(UNBOUNDED, box_b.half_size.y, box_b.half_size.x)));
    return overlap_boxes(seen, three_extrusions_view(above, vec3(box_c.centre.x, 0.0f, -box_c.centre.y),
                                                     vec3(box_c.half_size.x, UNBOUNDED, box_c.half_size.y)));
}
