// Pixel: what the rays of a pixel bring together.

struct Pixel {
    vec3 colour;
    float exhausted;
    float depth;  // -1 on a miss
    float node_id;
    float material_id;
    int steps;
    vec3 normal;
#if COUNTS
    int evaluations;  // of the field, by all rays
#endif
#if COVERAGE
    float covered;  // share in which something was hit
#endif
#if LAYERS
    Layers layers;
#endif
};

Pixel pixel_of(Sight sight, Ray ray)
{
    Pixel pixel;
    pixel.colour = sight.colour;
    pixel.exhausted = sight.exhausted != 0 || sight.budget <= 0 ? 1.0 : 0.0;
    pixel.depth = sight.hit ? sight.t * dot(ray.direction, ray.forward) : -1.0;
    pixel.node_id = sight.node_id;
    pixel.material_id = sight.material_id;
    pixel.steps = sight.steps;
    pixel.normal = sight.hit ? sight.normal : vec3(0.0);
#if COVERAGE
    pixel.covered = sight.hit ? 1.0 : 0.0;
#endif
#if LAYERS
    pixel.layers = sight.layers;
#endif
    return pixel;
}
#if COVERAGE

// The pixel, a share of whose light is that of another eye ray. Everything else stays that of its middle.
Pixel shared_pixel(Pixel pixel, Sight sight, float share)
{
    Pixel result = pixel;
    result.colour = mix(pixel.colour, sight.colour, share);
    result.covered = mix(pixel.covered, sight.hit ? 1.0 : 0.0, share);
    result.exhausted = sight.budget <= 0 ? 1.0 : pixel.exhausted;
#if LAYERS
    result.layers.ambient = mix(pixel.layers.ambient, sight.layers.ambient, share);
    result.layers.diffuse = mix(pixel.layers.diffuse, sight.layers.diffuse, share);
    result.layers.specular = mix(pixel.layers.specular, sight.layers.specular, share);
    result.layers.emission = mix(pixel.layers.emission, sight.layers.emission, share);
#endif
    return result;
}

// Where an eye ray met nothing, all or nothing of the sky shows; where nothing, a backdrop is laid.
Sight against_sky(Sight sight, float sky)
{
    Sight result = sight;
    float share = sight.hit ? 1.0 : sky;
    result.colour = share * sight.colour;
#if LAYERS
    result.layers.emission = share * sight.layers.emission;
#endif
    return result;
}
#endif

#if FOG
// way: from the eye to the start of the ray, in metres.
Sight in_fog(Sight sight, Fog fog, March march, vec3 origin, vec3 direction, float way)
{
    float t = sight.hit ? sight.t : march.far_limit;
    float through = fog_transmittance(fog, origin, direction, way, t);
    Sight result = sight;
    result.colour = mix(fog.colour, sight.colour, through);
#if BOUNCES
    result.split.mirrored = through * sight.split.mirrored;
    result.split.refracted = through * sight.split.refracted;
#endif
#if LAYERS
    result.layers.ambient = through * sight.layers.ambient;
    result.layers.diffuse = through * sight.layers.diffuse;
    result.layers.specular = through * sight.layers.specular;
    result.layers.emission = mix(fog.colour, sight.layers.emission, through);
#endif
    return result;
}

#endif
#if BOUNCES
// Around what see does, a loop over the rays that mirrors and glass send on, with the one call of scene_surface.
#endif
Pixel trace_pixel(Ray ray,
#if COVERAGE
                  Footprint footprint, float sky,
#endif
                  March march,
#if FOG
                  Fog fog,
#endif
                  int step_budget, int ray_count)
#if BOUNCES
{
#if COVERAGE
    Bounce waiting[BOUNCES + 3];
    bool first = true;
    float share = 0.0;
#else
    Bounce waiting[BOUNCES + 2];
#endif
#if TINTED_SHADOWS
    int overhead = ray_count + LIGHT_COUNT + 2 + (ray_count - 1) * BEAM_CROSSINGS;
#else
    int overhead = ray_count + LIGHT_COUNT + 2;
#endif
    waiting[0] = eye_bounce(ray, march);
    int count = 1;
    int budget = step_budget;
#if COUNTS
    int evaluations = 0;
#endif
    Pixel pixel;
    vec3 reflection = vec3(0.0);
    while (count > 0) {
        count--;
        Bounce bounce = waiting[count];
        Probe start = bounce_probe(bounce, march, budget, BOUNCES, overhead);
#if COVERAGE
        Edge edge = ignored_edge(start);
        if (first) edge = watched_edge(start, footprint);
        Sight sight = see(edge, march, ray_count, bounce.side);
#else
        Sight sight = see(start, march, ray_count, bounce.side);
#endif
        budget = sight.budget;
#if COUNTS
        evaluations += start.budget - budget;
#endif
#if FOG
        if (bounce.side > 0.0) sight = in_fog(sight, fog, march, bounce.origin, bounce.direction, bounce.way);
#endif
        float t = sight.t;
#if COVERAGE
        if (bounce.depth == 0) sight = against_sky(sight, sky);
        if (first) {
            pixel = pixel_of(sight, ray);
            Beyond beyond = edge_beyond(sight.edge, footprint);
            share = beyond.share;
            bounce.weight = vec3(1.0 - share);
            waiting[0] = eye_bounce(beyond_ray(ray, footprint, beyond), march);
            waiting[0].weight = vec3(share);
            count = share > 0.0 ? 1 : 0;
        }
        vec3 weight = bounce_weight(bounce, t);
        if (bounce.depth > 0) reflection += weight * sight.colour;
        else if (!first) pixel = shared_pixel(pixel, sight, share);
        first = false;
#else
        vec3 weight = bounce_weight(bounce, t);
        if (bounce.depth == 0) pixel = pixel_of(sight, ray);
        else reflection += weight * sight.colour;
#endif
        if (!sight.hit) continue;
        waiting[count] = mirrored_bounce(bounce, sight.split, weight, sight.position, sight.normal, t, march);
        count += bounce_shows(waiting[count]) ? 1 : 0;
        waiting[count] = refracted_bounce(bounce, sight.split, weight, sight.material, sight.position, sight.normal, t, march);
        count += bounce_shows(waiting[count]) ? 1 : 0;
    }
    pixel.colour += reflection;
    pixel.exhausted = budget <= 0 ? 1.0 : pixel.exhausted;
#if COUNTS
    pixel.evaluations = evaluations;
#endif
#if LAYERS
    pixel.layers.reflection = reflection;
#endif
    return pixel;
}
#else
{
#if COVERAGE
    Edge edge = watched_edge(eye_probe(ray, march, step_budget), footprint);
    Pixel pixel;
    float share = 0.0;
    int budget = step_budget;
    int turns = 1;  // no compiler unrolls what it does not know
    for (int turn = 0; turn < turns; turn++) {
        Sight sight = see(edge, march, ray_count, 1.0);
        budget = sight.budget;
#if FOG
        sight = in_fog(sight, fog, march, edge.probe.origin, edge.probe.direction, 0.0);
#endif
        sight = against_sky(sight, sky);
        if (turn == 0) {
            pixel = pixel_of(sight, ray);
            Beyond beyond = edge_beyond(sight.edge, footprint);
            share = beyond.share;
            turns = share > 0.0 ? 2 : 1;
            edge = ignored_edge(eye_probe(beyond_ray(ray, footprint, beyond), march, budget));
        } else {
            pixel = shared_pixel(pixel, sight, share);
        }
    }
#if COUNTS
    pixel.evaluations = step_budget - budget;
#endif
    return pixel;
#else
    Sight sight = see(eye_probe(ray, march, step_budget), march, ray_count, 1.0);
#if FOG
    sight = in_fog(sight, fog, march, ray.origin, ray.direction, 0.0);
#endif
    Pixel pixel = pixel_of(sight, ray);
#if COUNTS
    pixel.evaluations = step_budget - sight.budget;
#endif
    return pixel;
#endif
}
#endif
