// Blended subtract: The first shape without the second, the rim of the cut rounded with a blend of a chosen form.
// field: bound
// synonyms: cubic difference, circular difference, exponential difference, linear difference
// How far the blend reaches beyond the nearer shape where the distances differ by `apart`: zero from `size` on.
float blended_subtract_melt(float apart, float size, int kernel)
{
    float share = max(size - apart, 0.0f) / size;
    float linear = 0.5f * share;
    float cubic = share * share * share * (1.0f / 6.0f);
    float circular = 0.5f * (1.0f + share - sqrt(1.0f + share * (2.0f - share)));
    // The exponent is never positive, so nothing overflows; what is left at the end of the blend is taken off.
    float exponential = (log(1.0f + exp(6.0f * (share - 1.0f))) - 0.002475685f) * (1.0f / 6.0f);
    float rest = kernel == 2 ? circular : max(exponential, 0.0f);
    return size * (kernel == 0 ? linear : (kernel == 1 ? cubic : rest));
}

float blended_subtract_distance(
    float a,
    float b,
    float smoothness,  // 0.4 [0, 10] [0, 1] m  Size of the blend: it acts where the two surfaces are nearer than this.
    int kernel)        // circular {linear, cubic, circular, exponential}  Form of the blend: a bevel or a round.
{
    return max(a, -b) + blended_subtract_melt(abs(a + b), max(smoothness, 1.0e-6f), kernel);
}

float blended_subtract_blend(
    float a,
    float b,
    float smoothness,
    int cut_face)  // a {a, b, nearer}  Whose material the cut shows: a's, b's mixed in softly, or the nearer one's.
{
    float size = max(smoothness, 1.0e-6f);
    float share = 0.5f * max(size - abs(a + b), 0.0f) / size;
    float mixed = -b > a ? 1.0f - share : share;
    float nearer_b = -b > a ? 1.0f : 0.0f;
    return cut_face == 0 ? 0.0f : (cut_face == 1 ? mixed : nearer_b);
}

Box blended_subtract_bounds(Box box_a)
{
    return box_a;
}
