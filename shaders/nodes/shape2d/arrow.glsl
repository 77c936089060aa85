// Arrow: A straight shaft with a triangular head that points to the right.
// field: exact
// synonyms: pointer, direction, cursor, next
// Squared distance from q to the segment along `edge` from the origin.
float arrow_edge(vec2 q, vec2 edge)
{
    vec2 away = q - edge * clamp(dot(q, edge) / max(dot(edge, edge), 1.0e-20f), 0.0f, 1.0f);
    return dot(away, away);
}

float arrow_distance(
    vec2 p,
    float length_overall,  // 1.2 [0.01, 200] [0.1, 10] m  Length from the tail to the tip.
    float head_length,     // 0.45 [0.001, 200] [0.05, 5] m  Length of the head, at most the whole.
    float head_width,      // 0.7 [0.001, 200] [0.05, 5] m  Width of the head, at least that of the shaft.
    float thickness)       // 0.25 [0.001, 200] [0.01, 5] m  Width of the shaft.
{
    vec2 q = vec2(p.x + 0.5f * length_overall, abs(p.y));
    float shaft = 0.5f * thickness;
    float wing = max(0.5f * head_width, shaft);
    float neck = length_overall - min(head_length, length_overall);
    vec2 flank = vec2(length_overall - neck, -wing);
    vec2 from_wing = vec2(q.x - neck, q.y - wing);
    float squared = min(arrow_edge(q, vec2(0.0f, shaft)), arrow_edge(vec2(q.x, q.y - shaft), vec2(neck, 0.0f)));
    squared = min(squared, arrow_edge(from_wing, vec2(0.0f, shaft - wing)));
    squared = min(squared, arrow_edge(from_wing, flank));
    bool in_shaft = q.x > 0.0f && q.x < neck && q.y < shaft;
    bool in_head = q.x >= neck && flank.x * from_wing.y - flank.y * from_wing.x < 0.0f;
    return in_shaft || in_head ? -sqrt(squared) : sqrt(squared);
}

Box arrow_bounds(float length_overall, float head_width, float thickness)
{
    return make_box(vec3(0.0f), vec3(0.5f * length_overall, 0.5f * max(head_width, thickness), 0.0f));
}
