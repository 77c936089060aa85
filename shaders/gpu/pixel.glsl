// Pixel: a loop over rays (eye, one per shadowed light) around a loop of steps with the one call of scene_distance.

struct Pixel {
    vec3 colour;
    float exhausted;
    float depth;  // -1 on a miss
    float node_id;
    float material_id;
    int steps;
    vec3 normal;
};

// ray_count is 1 + SHADOW_COUNT, passed in so that no compiler unrolls the loop over rays.
Pixel trace_pixel(Ray ray, March march, int step_budget, int ray_count)
{
    Probe probe = eye_probe(ray, march, step_budget);
    Probe seen = probe;
    vec3 position = vec3(0.0);
    vec3 normal = vec3(0.0);
    bool hit = false;
    int lit = 0;  // bit i: shadowed light i is visible
    for (int index = 0; index < ray_count; index++) {
        if (index > 0) {
            probe = shadow_probe(position, normal, scene_light(index - 1, position), march, probe.budget);
        }
        while (!probe_done(probe)) {
            probe = advance(probe, scene_distance(probe_point(probe, march)), march);
        }
        if (index > 0) {
            lit |= probe_missed(probe) ? 1 << (index - 1) : 0;
        } else {
            seen = probe;
            hit = !probe_missed(probe);
            position = probe_point(probe, march);
            normal = probe_normal(probe);
            if (!hit) break;
        }
    }

    Pixel pixel;
    Surface surface;
    vec3 look = ray.direction;
    if (hit) {
        surface = scene_surface(position);
        look = ambient_direction(surface.material, normal, ray.direction);
    }
    pixel.colour = scene_sky(look);
    pixel.node_id = hit ? surface.node_id : 0.0;
    pixel.material_id = hit ? surface.material_id : 0.0;
    if (hit) {
        pixel.colour = shade_ambient(surface.material, pixel.colour, seen.openness);
        for (int index = 0; index < LIGHT_COUNT; index++) {
            bool visible = index >= SHADOW_COUNT || (lit & (1 << index)) != 0;
            Light light = scene_light(index, position);
            pixel.colour += shade_light(surface.material, normal, -ray.direction, light, visible ? 1.0 : 0.0);
        }
    }
    pixel.exhausted = seen.exhausted != 0 || probe.budget <= 0 ? 1.0 : 0.0;
    pixel.depth = hit ? seen.t * dot(ray.direction, ray.forward) : -1.0;
    pixel.steps = seen.steps;
    pixel.normal = hit ? normal : vec3(0.0);
    return pixel;
}
