// Pixel: a loop over rays (eye, one per shadowed light) around a loop of steps with the one call of scene_distance.
#if BOUNCES
// Around both, a loop over the rays that mirrors and glass send on, with the one call of scene_surface.
#endif

#if LAYERS
// How the colour came about; it is the sum of the first five.
struct Layers {
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
    vec3 reflection;
    vec3 emission;
    vec3 albedo;
    vec3 position;
    float shadow;
    float occlusion;
    float gradient_length;
    float cone_ratio;
    int shadow_steps;
};

#endif
struct Pixel {
    vec3 colour;
    float exhausted;
    float depth;  // -1 on a miss
    float node_id;
    float material_id;
    int steps;
    vec3 normal;
#if LAYERS
    Layers layers;
#endif
};

// What one ray meets, and the colour that it brings itself.
struct Sight {
    float t;  // where it ended
    int steps;
    int exhausted;
    float openness;
    int budget;  // left after its shadow rays
    bool hit;
    vec3 position;
    vec3 normal;
    float node_id;
    float material_id;
    vec3 colour;
#if BOUNCES
    Material material;
    Split split;
#endif
#if LAYERS
    float gradient_length;
    float cone_ratio;
    Layers layers;
#endif
};

// The probe after the distance d.
Probe next_probe(Probe probe, float d, March march)
{
#if BISECTS
    Probe next = advance_bisecting(probe, d, march);
#else
    Probe next = advance(probe, d, march);
#endif
#if CONES
    next = narrowed(probe, next, d, march);
#endif
    return next;
}

// ray_count is 1 + SHADOW_COUNT, passed in so that no compiler unrolls the loop over rays.
#if BOUNCES
// side: the factor on distances; inside a solid no light is seen.
Sight see(Probe start, March march, int ray_count, float side)
#else
Sight see(Probe start, March march, int ray_count)
#endif
{
    Probe probe = start;
    Sight sight;
    sight.t = start.t;
    sight.steps = 0;
    sight.exhausted = 0;
    sight.openness = 1.0;
    sight.hit = false;
    sight.position = vec3(0.0);
    sight.normal = vec3(0.0);
#if CONES
    float visibility[SHADOW_COUNT + 1];
#else
    int lit = 0;  // bit i: shadowed light i is visible; an array would take longer to compile
#endif
#if LAYERS
    int shadow_steps = 0;
#endif
    for (int index = 0; index < ray_count; index++) {
        if (index > 0) {
            Light light = scene_light(index - 1, sight.position);
            probe = shadow_probe(sight.position, sight.normal, light, scene_shadow(index - 1), march, probe.budget);
        }
        while (!probe_done(probe)) {
#if BOUNCES
            float d = side * scene_distance(probe_point(probe, march));
#else
            float d = scene_distance(probe_point(probe, march));
#endif
            probe = next_probe(probe, d, march);
        }
        if (index > 0) {
#if CONES
            visibility[index - 1] = shadow_visibility(probe, scene_light(index - 1, sight.position), scene_shadow(index - 1));
#else
            lit |= probe_missed(probe) ? 1 << (index - 1) : 0;
#endif
#if LAYERS
            shadow_steps += probe.steps;
#endif
        } else {
            sight.t = probe.t;
            sight.steps = probe.steps;
            sight.exhausted = probe.exhausted;
            sight.openness = probe.openness;
#if LAYERS
            sight.gradient_length = length(probe.gradient);
            sight.cone_ratio = probe.cone_ratio;
#endif
            sight.hit = !probe_missed(probe);
            sight.position = probe_point(probe, march);
            sight.normal = probe_normal(probe);
#if BOUNCES
            if (!sight.hit || side < 0.0) break;
#else
            if (!sight.hit) break;
#endif
        }
    }
    sight.budget = probe.budget;

    vec3 direction = start.direction;
    vec3 look = direction;
    float spread = 0.0;
    Surface surface;
    if (sight.hit) {
        surface = scene_surface(sight.position);
#if BOUNCES
        sight.material = surface.material;
        sight.split = split_light(surface.material, sight.normal, direction, side);
        surface.material = scattering_material(surface.material, sight.split);
        Material under_sky = ambient_material(surface.material);
#else
        Material under_sky = surface.material;
#endif
        look = ambient_direction(under_sky, sight.normal, direction);
        spread = ambient_spread(under_sky);
    }
    vec3 sky = scene_sky(look, spread);
    sight.colour = sky;
    sight.node_id = sight.hit ? surface.node_id : 0.0;
    sight.material_id = sight.hit ? surface.material_id : 0.0;
#if LAYERS
    sight.layers = Layers(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), sky, vec3(0.0), vec3(0.0), 1.0, 1.0, 0.0, sight.cone_ratio, 0);
#endif
    if (sight.hit) {
#if BOUNCES
        vec3 ambient = shade_ambient(ambient_material(surface.material), sky, sight.openness);
#else
        vec3 ambient = shade_ambient(surface.material, sky, sight.openness);
#endif
#if LAYERS
        vec3 diffuse = vec3(0.0);
        vec3 specular = vec3(0.0);
        float visible_lights = 0.0;
#endif
        sight.colour = ambient + surface.material.emission;
        for (int index = 0; index < LIGHT_COUNT; index++) {
#if CONES
            float visible = index < SHADOW_COUNT ? visibility[index] : 1.0;
#else
            float visible = index >= SHADOW_COUNT || (lit & (1 << index)) != 0 ? 1.0 : 0.0;
#endif
#if BOUNCES
            visible = side > 0.0 ? visible : 0.0;
#endif
            Light light = scene_light(index, sight.position);
#if LAYERS
            diffuse += shade_diffuse(surface.material, sight.normal, light, visible);
            specular += shade_specular(surface.material, sight.normal, -direction, light, visible);
            visible_lights += index < SHADOW_COUNT ? visible : 0.0;
#else
            sight.colour += shade_light(surface.material, sight.normal, -direction, light, visible);
#endif
        }
#if LAYERS
        sight.colour += diffuse + specular;
        sight.layers.ambient = ambient;
        sight.layers.diffuse = diffuse;
        sight.layers.specular = specular;
        sight.layers.emission = surface.material.emission;
#if BOUNCES
        sight.layers.albedo = sight.material.albedo;
#else
        sight.layers.albedo = surface.material.albedo;
#endif
        sight.layers.position = sight.position;
        sight.layers.shadow = SHADOW_COUNT > 0 ? visible_lights / float(max(SHADOW_COUNT, 1)) : 1.0;
        sight.layers.occlusion = sight.openness;
        sight.layers.gradient_length = sight.gradient_length;
        sight.layers.shadow_steps = shadow_steps;
#endif
    }
    return sight;
}

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
#if LAYERS
    pixel.layers = sight.layers;
#endif
    return pixel;
}

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
#if FOG
Pixel trace_pixel(Ray ray, March march, Fog fog, int step_budget, int ray_count)
#else
Pixel trace_pixel(Ray ray, March march, int step_budget, int ray_count)
#endif
{
#if BOUNCES
    Bounce waiting[BOUNCES + 2];
    waiting[0] = eye_bounce(ray, march);
    int count = 1;
    int budget = step_budget;
    Pixel pixel;
    vec3 reflection = vec3(0.0);
    while (count > 0) {
        count--;
        Bounce bounce = waiting[count];
        Probe start = bounce_probe(bounce, march, budget, BOUNCES, ray_count + LIGHT_COUNT + 2);
        Sight sight = see(start, march, ray_count, bounce.side);
        budget = sight.budget;
#if FOG
        if (bounce.side > 0.0) sight = in_fog(sight, fog, march, bounce.origin, bounce.direction, bounce.way);
#endif
        float t = sight.t;
        vec3 weight = bounce_weight(bounce, t);
        if (bounce.depth == 0) pixel = pixel_of(sight, ray);
        else reflection += weight * sight.colour;
        if (!sight.hit) continue;
        waiting[count] = mirrored_bounce(bounce, sight.split, weight, sight.position, sight.normal, t, march);
        count += bounce_shows(waiting[count]) ? 1 : 0;
        waiting[count] = refracted_bounce(bounce, sight.split, weight, sight.material, sight.position, sight.normal, t, march);
        count += bounce_shows(waiting[count]) ? 1 : 0;
    }
    pixel.colour += reflection;
    pixel.exhausted = budget <= 0 ? 1.0 : pixel.exhausted;
#if LAYERS
    pixel.layers.reflection = reflection;
#endif
    return pixel;
#else
    Sight sight = see(eye_probe(ray, march, step_budget), march, ray_count);
#if FOG
    sight = in_fog(sight, fog, march, ray.origin, ray.direction, 0.0);
#endif
    return pixel_of(sight, ray);
#endif
}
