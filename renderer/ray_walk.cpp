// Walks one probe with the functions that walk them all.
#include "renderer/ray_walk.h"

#include "renderer/cpu_marcher.h"

#include <algorithm>

namespace fieldwright::renderer {
namespace {

void put(Rows& rows, int first_lane, glm::vec3 value)
{
    for (int k = 0; k < 3; ++k) rows.lane(first_lane + k)[0] = value[k];
}

}  // namespace

WorldRay ray_of_pixel(const graph::Program& program, const FrameRequest& request, glm::ivec2 pixel)
{
    const CpuScene scene(program, request);
    auto width = static_cast<float>(request.width), height = static_cast<float>(request.height);
    Rows uv(4), camera_ray(scene.lanes.ray), ray(scene.lanes.ray);
    uv.lane(0)[0] = (2 * (static_cast<float>(pixel.x) + 0.5f) - width) / height;
    uv.lane(1)[0] = (height - 2 * (static_cast<float>(pixel.y) + 0.5f)) / height;
    if (scene.view) scene.view_ray(camera_ray, 1, uv, *scene.view);
    else Stage(scene.ray, scene.block)(camera_ray, uv, 1);
    scene.stereo_ray(ray, 1, camera_ray, scene.eye, scene.interaxial, scene.convergence, scene.toe_in);
    return {ray.vec3(0, 0), ray.vec3(scene.lanes.ray_direction, 0)};
}

RayWalk walk_ray(const graph::Program& program, float time_s, const WorldRay& world_ray)
{
    const CpuScene scene(program, {.time = time_s});
    const graph::Library& library = *program.library;
    const int phase = member_lane(library, "Probe", "phase");
    Stage distance(scene.distance, scene.block);
    Rows ray(scene.lanes.ray), probe(scene.lanes.probe), next(scene.lanes.probe), point(3), d(1), missed(1);
    put(ray, member_lane(library, "Ray", "origin"), world_ray.origin);
    for (int lane : {scene.lanes.ray_direction, scene.lanes.ray_forward}) put(ray, lane, world_ray.direction);
    scene.eye_probe(probe, 1, ray, scene.march, scene.budget);

    RayWalk walk{.ray = world_ray};
    while (probe.lane(phase)[0] == 0) {  // MARCHING
        scene.probe_point(point, 1, probe, scene.march);
        distance(d, point, 1);
        float t = probe.lane(scene.lanes.probe_t)[0], seen = d.lane(0)[0];
        walk.steps.push_back({t, seen, seen / std::max(t, 1e-6f)});
        scene.advance(next, 1, probe, d, scene.march);
        std::swap(probe, next);
    }
    scene.probe_missed(missed, 1, probe);
    walk.t_end = probe.lane(scene.lanes.probe_t)[0];
    if (missed.lane(0)[0] < 0.5f) walk.end = RayWalk::End::hit;
    if (probe.lane(scene.lanes.probe_exhausted)[0] > 0.5f) walk.end = RayWalk::End::out_of_steps;
    return walk;
}

}  // namespace fieldwright::renderer
