// Menger sponge: A cube with square holes through it, and smaller holes through what is left.
// field: bound
// synonyms: fractal, sponge, cube fractal, holes
float menger_sponge_distance(
    vec3 p,
    float half_size,  // 0.7 [0.001, 100] [0.05, 5] m  Half the length of the edges.
    int levels)       // 3 [0, 6] [0, 5]  How many sizes of holes there are.
{
    vec3 q = p / half_size;
    vec3 beyond = abs(q) - vec3(1.0f);
    float solid = length(max(beyond, vec3(0.0f))) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0f);
    float size = 1.0f;
    for (int i = 0; i < 6; i++) {
        if (i >= levels) {
            break;
        }
        // Within its cell of width 2 size, the hole is a cross of three square bars of a third of that.
        vec3 cells = (q + vec3(size)) / (2.0f * size);
        vec3 place = abs((cells - floor(cells)) * 2.0f - vec3(1.0f)) * size;
        float bars = min(max(place.x, place.y), min(max(place.y, place.z), max(place.z, place.x)));
        size = size / 3.0f;
        solid = max(solid, size - bars);
    }
    return solid * half_size;
}

Box menger_sponge_bounds(float half_size)
{
    return make_box(vec3(0.0f), vec3(half_size));
}
