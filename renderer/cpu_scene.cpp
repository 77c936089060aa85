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

Rows march_rows(const graph::Program& program, bool tinted_shadows)
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
    set("step_scale", graph::step_scale(program.march));
    set("constant_step", program.march.constant_step);
    set("normal_step", program.march.normal_step);
    set("occlusion_samples", static_cast<float>(program.occlusion.samples));
    set("occlusion_strength", program.occlusion.strength);
    set("occlusion_radius", program.occlusion.radius);
    set("bisects", program.march.constant_steps ? 1.0f : 0.0f);
    set("central_normals", program.march.central_normals ? 1.0f : 0.0f);
    set("smallest_occlusion", program.occlusion.smallest_ratio ? 1.0f : 0.0f);
    set("tracks_cone", graph::tracks_cone(program) ? 1.0f : 0.0f);
    set("tints_shadows", tinted_shadows ? 1.0f : 0.0f);
    return rows;
}

Rows shadow_march_rows(const Rows& march, const field::KernelTable& table)
{
    Rows rows(march.lanes());
    RowFunction("shadow_march", table)(rows, field::row_width, march);
    return rows;
}

Rows fog_rows(const graph::Program& program)
{
    const graph::Library& library = *program.library;
    Rows rows(structure_lanes(library, "Fog"));
    auto lane = [&](std::string_view member) { return member_lane(library, "Fog", member); };
    for (int k = 0; k < 3; ++k) rows.fill(lane("colour") + k, program.fog.colour[k]);
    rows.fill(lane("density"), program.fog.density);
    rows.fill(lane("start"), program.fog.start);
    rows.fill(lane("height_falloff"), program.fog.height_falloff);
    return rows;
}

Rows lens_rows(glm::vec2 lens)
{
    Rows rows(2);
    for (int k = 0; k < 2; ++k) rows.fill(k, lens[k]);
    return rows;
}

Rows view_rows(const graph::Library& library, const Viewpoint& view)
{
    Rows rows(structure_lanes(library, "Viewpoint"));
    auto lane = [&](std::string_view member) { return member_lane(library, "Viewpoint", member); };
    auto set = [&](std::string_view member, const glm::vec3& value) {
        for (int k = 0; k < 3; ++k) rows.fill(lane(member) + k, value[k]);
    };
    set("position", view.position);
    set("forward", view.forward);
    set("right", view.right);
    set("upward", view.upward);
    rows.fill(lane("slope"), view.slope);
    rows.fill(lane("half_height"), view.half_height);
    return rows;
}

// As in shaders/gpu/pixel.glsl: loop iterations of a ray beside its steps.
int ray_overhead(const graph::Program& program, bool tinted_shadows)
{
    int shadows = graph::shadow_count(program), crossings = tinted_shadows ? shadows * beam_crossings : 0;
    return 1 + shadows + static_cast<int>(program.lights.size()) + 2 + crossings;
}

std::vector<field::Evaluator> light_evaluators(const graph::Program& program, const field::KernelTable& table)
{
    std::vector<field::Evaluator> evaluators;
    for (const graph::LightEntry& light : program.lights) evaluators.emplace_back(program, light.entry, table);
    return evaluators;
}

// By light: the kind of its shadow.
std::vector<Rows> shadow_rows(const graph::Program& program)
{
    std::vector<Rows> rows;
    for (const graph::LightEntry& light : program.lights)
        rows.push_back(constant_rows(static_cast<float>(light.shadow)));
    return rows;
}

}  // namespace

StructureLanes::StructureLanes(const graph::Library& library)
    : probe(structure_lanes(library, "Probe")),
      material(structure_lanes(library, "Material")),
      light(structure_lanes(library, "Light")),
      ray(structure_lanes(library, "Ray")),
      bounce(structure_lanes(library, "Bounce")),
      split(structure_lanes(library, "Split")),
      beam(structure_lanes(library, "Beam")),
      probe_origin(member_lane(library, "Probe", "origin")),
      probe_direction(member_lane(library, "Probe", "direction")),
      probe_t(member_lane(library, "Probe", "t")),
      probe_steps(member_lane(library, "Probe", "steps")),
      probe_budget(member_lane(library, "Probe", "budget")),
      probe_exhausted(member_lane(library, "Probe", "exhausted")),
      probe_gradient(member_lane(library, "Probe", "gradient")),
      probe_openness(member_lane(library, "Probe", "openness")),
      probe_cone_ratio(member_lane(library, "Probe", "cone_ratio")),
      material_albedo(member_lane(library, "Material", "albedo")),
      material_emission(member_lane(library, "Material", "emission")),
      ray_direction(member_lane(library, "Ray", "direction")),
      ray_forward(member_lane(library, "Ray", "forward")),
      bounce_side(member_lane(library, "Bounce", "side")),
      bounce_way(member_lane(library, "Bounce", "way")),
      bounce_weight(member_lane(library, "Bounce", "weight")),
      light_radiance(member_lane(library, "Light", "radiance")),
      beam_side(member_lane(library, "Beam", "side")),
      edge(structure_lanes(library, "Edge")),
      footprint(structure_lanes(library, "Footprint")),
      beyond(structure_lanes(library, "Beyond"))
{
}

CpuScene::CpuScene(const graph::Program& program, const FrameRequest& frame_request, const field::KernelTable& table)
    : request(frame_request),
      block(field::evaluate_frame(program, frame_request.time)),
      lanes(*program.library),
      shadow_count(graph::shadow_count(program)),
      features(codegen::features_of(program, block, frame_request.layers)),
      far_limit(program.march.far),
      fog_colour(program.fog.colour),
      distance(program, program.distance, table),
      surface(program, program.surface, table),
      ray(program, program.ray, table),
      sky(program, program.sky, table),
      lights(light_evaluators(program, table)),
      shadows(shadow_rows(program)),
      march(march_rows(program, features.tinted_shadows)),
      march_of_shadows(shadow_march_rows(march, table)),
      fog(fog_rows(program)),
      budget(constant_rows(static_cast<float>(program.step_budget))),
      bounces(constant_rows(static_cast<float>(program.bounces))),
      overhead(constant_rows(static_cast<float>(ray_overhead(program, features.tinted_shadows)))),
      eye(constant_rows(eye_side(frame_request.eye))),
      interaxial(constant_rows(frame_request.interaxial)),
      convergence(constant_rows(frame_request.convergence)),
      toe_in(constant_rows(frame_request.toe_in ? 1.0f : 0.0f)),
      lens(lens_rows(frame_request.lens)),
      view_ray("view_ray", table),
      stereo_ray("stereo_ray", table),
      eye_probe("eye_probe", table),
      shadow_probe("shadow_probe", table),
      probe_point("probe_point", table),
      advance(program.march.constant_steps ? "advance_bisecting" : "advance", table),
      narrowed("narrowed", table),
      probe_done("probe_done", table),
      probe_missed("probe_missed", table),
      shadow_visibility("shadow_visibility", table),
      probe_normal("probe_normal", table),
      ambient_spread("ambient_spread", table),
      ambient_direction("ambient_direction", table),
      shade_ambient("shade_ambient", table),
      shade_light("shade_light", table),
      shade_diffuse("shade_diffuse", table),
      shade_specular("shade_specular", table),
      eye_bounce("eye_bounce", table),
      bounce_probe("bounce_probe", table),
      split_light("split_light", table),
      scattering_material("scattering_material", table),
      ambient_material("ambient_material", table),
      bounce_weight("bounce_weight", table),
      bounce_shows("bounce_shows", table),
      mirrored_bounce("mirrored_bounce", table),
      refracted_bounce("refracted_bounce", table),
      fog_transmittance("fog_transmittance", table),
      make_beam("make_beam", table),
      beam_asks("beam_asks", table),
      beam_point("beam_point", table),
      beam_behind("beam_behind", table),
      next_leg("next_leg", table),
      beam_stopped("beam_stopped", table),
      beam_visibility("beam_visibility", table),
      brightness("brightness", table),
      turned_lens("turned_lens", table),
      make_footprint("make_footprint", table),
      watched_edge("watched_edge", table),
      edge_done("edge_done", table),
      edge_point("edge_point", table),
      next_edge("next_edge", table),
      edge_beyond("edge_beyond", table),
      beyond_ray("beyond_ray", table)
{
    if (request.camera) view = view_rows(*program.library, viewpoint_of(*request.camera));
}

}  // namespace fieldwright::renderer
