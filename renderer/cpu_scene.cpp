// Prepares a program for drawing on the CPU.
#include "renderer/cpu_scene.h"

namespace fieldwright::renderer {
namespace {

Rows constant_rows(float value)
{
    Rows rows(1);
    rows.fill(0, value);
    return rows;
}

Rows march_rows(const graph::Program& program)
{
    const graph::Library& library = *program.library;
    Rows rows(structure_lanes(library, "March"));
    auto set = [&](std::string_view member, float value) { rows.fill(member_lane(library, "March", member), value); };
    set("step_limit", static_cast<float>(program.march.step_limit));
    set("minimum_step", program.march.minimum_step);
    set("tolerance", program.march.tolerance);
    set("near_limit", program.march.near);
    set("far_limit", program.march.far);
    set("out_of_steps_hits", program.march.out_of_steps_hits ? 1.0f : 0.0f);
    set("occlusion_strength", program.occlusion.strength);
    set("occlusion_radius", program.occlusion.radius);
    return rows;
}

Rows camera_rows(const graph::Library& library, const ViewCamera& camera)
{
    Rows rows(structure_lanes(library, "ViewCamera"));
    auto lane = [&](std::string_view member) { return member_lane(library, "ViewCamera", member); };
    auto set = [&](std::string_view member, const glm::vec3& value) {
        for (int k = 0; k < 3; ++k) rows.fill(lane(member) + k, value[k]);
    };
    set("position", camera.position);
    set("target", camera.target);
    set("up", camera.up);
    rows.fill(lane("field_of_view"), camera.field_of_view_rad);
    rows.fill(lane("orthographic_height"), camera.orthographic_height);
    return rows;
}

std::vector<field::Evaluator> light_evaluators(const graph::Program& program, const field::KernelTable& table)
{
    std::vector<field::Evaluator> evaluators;
    for (const graph::LightEntry& light : program.lights) evaluators.emplace_back(program, light.entry, table);
    return evaluators;
}

}  // namespace

StructureLanes::StructureLanes(const graph::Library& library)
    : probe(structure_lanes(library, "Probe")),
      material(structure_lanes(library, "Material")),
      light(structure_lanes(library, "Light")),
      ray(structure_lanes(library, "Ray")),
      probe_t(member_lane(library, "Probe", "t")),
      probe_steps(member_lane(library, "Probe", "steps")),
      probe_budget(member_lane(library, "Probe", "budget")),
      probe_exhausted(member_lane(library, "Probe", "exhausted")),
      probe_openness(member_lane(library, "Probe", "openness")),
      ray_direction(member_lane(library, "Ray", "direction")),
      ray_forward(member_lane(library, "Ray", "forward"))
{
}

CpuScene::CpuScene(const graph::Program& program, const FrameRequest& frame_request, const field::KernelTable& table)
    : request(frame_request),
      block(field::evaluate_frame(program, frame_request.time)),
      lanes(*program.library),
      shadow_count(renderer::shadow_count(program)),
      distance(program, program.distance, table),
      surface(program, program.surface, table),
      ray(program, program.ray, table),
      sky(program, program.sky, table),
      lights(light_evaluators(program, table)),
      march(march_rows(program)),
      budget(constant_rows(static_cast<float>(program.step_budget))),
      eye(constant_rows(eye_side(frame_request.eye))),
      interaxial(constant_rows(frame_request.interaxial)),
      convergence(constant_rows(frame_request.convergence)),
      view_ray("view_ray", table),
      stereo_ray("stereo_ray", table),
      eye_probe("eye_probe", table),
      shadow_probe("shadow_probe", table),
      probe_point("probe_point", table),
      advance("advance", table),
      probe_done("probe_done", table),
      probe_missed("probe_missed", table),
      probe_normal("probe_normal", table),
      ambient_direction("ambient_direction", table),
      shade_ambient("shade_ambient", table),
      shade_light("shade_light", table)
{
    if (request.camera) view_camera = camera_rows(*program.library, *request.camera);
}

}  // namespace fieldwright::renderer
