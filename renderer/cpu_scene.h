// What every tile of a CPU picture shares: the program's evaluators, the marcher's functions and their constants.
#pragma once

#include "codegen/features.h"
#include "field/evaluator.h"
#include "renderer/frame.h"
#include "renderer/rows.h"

namespace fieldwright::renderer {

// Where the members of the shading library's structures lie among a value's lanes.
struct StructureLanes {
    explicit StructureLanes(const graph::Library& library);
    int probe, material, light, ray, bounce, split, beam;  // lanes in all
    int probe_origin, probe_direction, probe_t, probe_steps, probe_budget, probe_exhausted, probe_gradient,
        probe_openness, probe_cone_ratio;
    int material_albedo, material_emission;
    int ray_direction, ray_forward;
    int bounce_side, bounce_way, bounce_weight;
    int light_radiance, beam_side;
    int edge, footprint, beyond;
};

inline constexpr int beam_crossings = 16;  // BEAM_CROSSINGS of render/tinted_shadow.glsl

// Immutable while tiles are drawn; threads share it.
struct CpuScene {
    CpuScene(const graph::Program& program, const FrameRequest& request,
             const field::KernelTable& table = field::kernels());

    FrameRequest request;
    std::vector<float> block;
    StructureLanes lanes;
    int shadow_count;
    codegen::Features features;
    float far_limit;       // m
    glm::vec3 fog_colour;  // linear

    field::Evaluator distance, surface, ray, sky;
    std::vector<field::Evaluator> lights;  // shadowed first
    std::vector<Rows> shadows;             // by light: the kind of its shadow, spread over a row

    Rows march, march_of_shadows, fog, budget, bounces, overhead, eye, interaxial, convergence, toe_in,
        lens;                  // constants, spread over a row
    std::optional<Rows> view;  // when the request has one
    RowFunction view_ray, stereo_ray, eye_probe, shadow_probe, probe_point, advance, narrowed, probe_done, probe_missed,
        shadow_visibility, probe_normal, ambient_spread, ambient_direction, shade_ambient, shade_light, shade_diffuse,
        shade_specular;
    RowFunction eye_bounce, bounce_probe, split_light, scattering_material, ambient_material, bounce_weight,
        bounce_shows, mirrored_bounce, refracted_bounce, fog_transmittance;
    RowFunction make_beam, beam_asks, beam_point, beam_behind, next_leg, beam_stopped, beam_visibility, brightness,
        turned_lens;
    RowFunction make_footprint, watched_edge, edge_done, edge_point, next_edge, edge_beyond, beyond_ray;
};

}  // namespace fieldwright::renderer
