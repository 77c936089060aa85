// Mandelbox: A fractal box of halls and towers: space folded at planes and at a ball, and enlarged, again and again.
// field: approximate 0.6
// synonyms: fractal, box fractal, city, fold fractal
// Half the width of the whole, in units of the folds.
float mandelbox_reach(float enlargement)
{
    return 2.0f * (enlargement + 1.0f) / (enlargement - 1.0f);
}

float mandelbox_distance(
    vec3 p,
    float half_size,    // 0.8 [0.001, 100] [0.05, 5] m  Half the length of the edges.
    float enlargement,  // 2.2 [1.5, 4] [1.5, 3]  How much each fold enlarges what it folded.
    float ball,         // 0.7 [0.05, 1]  Radius of the small ball, within which points are thrown outwards alike.
    int iterations)     // 3 [1, 12] [1, 8]  How many folds there are: more show finer halls.
{
    float reach = mandelbox_reach(enlargement);
    vec3 place = p * (reach / half_size);
    vec3 z = place;
    float slope = 1.0f;
    float least = ball * ball;
    for (int i = 0; i < 12; i++) {
        bool going = i < iterations;
        vec3 folded = clamp(z, vec3(-1.0f), vec3(1.0f)) * 2.0f - z;
        float squared = dot(folded, folded);
        float thrown = squared < least ? 1.0f / least : (squared < 1.0f ? 1.0f / squared : 1.0f);
        z = going ? folded * (enlargement * thrown) + place : z;
        slope = going ? slope * enlargement * thrown + 1.0f : slope;
    }
    float estimate = (length(z) - reach) / slope;
    vec3 beyond = abs(place) - vec3(reach);
    float box = length(max(beyond, vec3(0.0f))) + min(max(beyond.x, max(beyond.y, beyond.z)), 0.0f);
    return (half_size / reach) * max(box, estimate);
}

Box mandelbox_bounds(float half_size)
{
    return make_box(vec3(0.0f), vec3(half_size));
}
