// What every tile of a CPU picture shares: the program's evaluators, the marcher's functions and their constants.
#pragma once

#include "field/evaluator.h"
#include "renderer/frame.h"
#include "renderer/rows.h"

namespace fieldwright::renderer {

// Where the members of the shading library's structures lie among a value's lanes.
struct StructureLanes {
    explicit StructureLanes(const graph::Library& library);
    int probe, material, light, ray;  // lanes in all
    int probe_t, probe_steps, probe_budget, probe_exhausted, probe_openness;
    int ray_direction, ray_forward;
};

// Immutable while tiles are drawn; threads share it.
struct CpuScene {
    CpuScene(const graph::Program& program, const FrameRequest& request,
             const field::KernelTable& table = field::kernels());

    FrameRequest request;
    std::vector<float> block;
    StructureLanes lanes;
    int shadow_count;

    field::Evaluator distance, surface, ray, sky;
    std::vector<field::Evaluator> lights;  // shadowed first

    Rows march, budget, eye, interaxial, convergence;  // constants, spread over a row
    std::optional<Rows> view_camera;                   // when the request has one
    RowFunction view_ray, stereo_ray, eye_probe, shadow_probe, probe_point, advance, probe_done, probe_missed,
        probe_normal, ambient_direction, shade_ambient, shade_light;
};

}  // namespace fieldwright::renderer
