// Sight: a loop over rays (that of the eye or of a bounce, one per shadowed light) around a loop of steps with the one
// call of scene_distance.

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
#if COVERAGE
    Edge edge;
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

// side: the factor on distances; inside a solid no light is seen. ray_count is 1 + SHADOW_COUNT, passed in so that no
// compiler unrolls the loop over rays.
#if COVERAGE
Sight see(Edge first, March march, int ray_count, float side)
{
    Probe start = first.probe;
#else
Sight see(Probe start, March march, int ray_count, float side)
{
#endif
    Probe probe = start;
    Sight sight;
    sight.t = start.t;
    sight.steps = 0;
    sight.exhausted = 0;
    sight.openness = 1.0;
    sight.hit = false;
    sight.position = vec3(0.0);
    sight.normal = vec3(0.0);
    Surface surface;
#if TINTED_SHADOWS
    vec3 visibility[SHADOW_COUNT + 1];
#else
#if CONES
    float visibility[SHADOW_COUNT + 1];
#else
    int lit = 0;  // bit i: shadowed light i is visible; an array would take longer to compile
#endif
#endif
#if LAYERS
    int shadow_steps = 0;
#endif
    for (int index = 0; index < ray_count; index++) {
        Light light;
        if (index > 0) {
            light = scene_light(index - 1, sight.position);
            probe = shadow_probe(sight.position, sight.normal, light, scene_shadow(index - 1), march, probe.budget);
        }
#if COVERAGE
        Edge edge = first;
        if (index > 0) edge = ignored_edge(probe);
#endif
        March leg_march = march;
        float leg_side = side;
#if TINTED_SHADOWS
        // Legs of a shadow ray from surface to surface; of the eye's the first ends it.
        Beam beam = make_beam();
        if (index > 0) leg_march = shadow_march(march);
        for (int crossing = 0; crossing <= BEAM_CROSSINGS; crossing++)
#endif
        {
#if TINTED_SHADOWS
            if (index > 0) leg_side = beam.side;
#endif
#if COVERAGE
            while (!edge_done(edge)) {
                float d = leg_side * scene_distance(edge_point(edge, leg_march));
                edge = next_edge(edge, next_probe(edge.probe, d, leg_march), d, leg_march);
            }
            probe = edge.probe;
            if (index == 0) sight.edge = edge;
#else
            while (!probe_done(probe)) {
                float d = leg_side * scene_distance(probe_point(probe, leg_march));
                probe = next_probe(probe, d, leg_march);
            }
#endif
#if TINTED_SHADOWS
            bool asks = index > 0 ? beam_asks(probe, light, scene_shadow(index - 1)) : !probe_missed(probe);
            if (!asks) break;
            Surface met = scene_surface(index > 0 ? beam_point(probe) : probe_point(probe, march));
            if (index == 0) {
                surface = met;
                break;
            }
            beam = beam_behind(beam, probe, met.material, light, scene_shadow(index - 1));
            probe = next_leg(probe, beam, scene_shadow(index - 1), march);
            if (beam_stopped(probe)) break;
#if COVERAGE
            edge = ignored_edge(probe);
#endif
#endif
        }
        if (index > 0) {
#if TINTED_SHADOWS
            visibility[index - 1] = beam_visibility(beam, probe);
#else
#if CONES
            visibility[index - 1] = shadow_visibility(probe, light, scene_shadow(index - 1));
#else
            lit |= probe_missed(probe) ? 1 << (index - 1) : 0;
#endif
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
            if (!sight.hit || side < 0.0) break;
        }
    }
    sight.budget = probe.budget;

    vec3 direction = start.direction;
    vec3 look = direction;
    float spread = 0.0;
    if (sight.hit) {
#if TINTED_SHADOWS
        // The loop has asked it.
#else
        surface = scene_surface(sight.position);
#endif
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
#if TINTED_SHADOWS
            vec3 tint = index < SHADOW_COUNT ? visibility[index] : vec3(1.0);
            float visible = 1.0;
#else
#if CONES
            float visible = index < SHADOW_COUNT ? visibility[index] : 1.0;
#else
            float visible = index >= SHADOW_COUNT || (lit & (1 << index)) != 0 ? 1.0 : 0.0;
#endif
#endif
            visible = side > 0.0 ? visible : 0.0;
            Light light = scene_light(index, sight.position);
#if TINTED_SHADOWS
            light.radiance *= tint;
#endif
#if LAYERS
            diffuse += shade_diffuse(surface.material, sight.normal, light, visible);
            specular += shade_specular(surface.material, sight.normal, -direction, light, visible);
#if TINTED_SHADOWS
            visible *= brightness(tint);
#endif
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
