// The program as GLSL: flat assignments, functions of at most 32 primitives, identifiers n<id>.
#pragma once

#include "graph/program.h"

#include <span>
#include <string>

namespace fieldwright::codegen {

enum class Placement {
    literals,  // constants as literals, frame values from the block: software GL and exports
    buffer     // everything from the block: GPUs; a drag leaves the text
};

// The scene part: the shading library's types, the node functions used, then scene_distance(vec3 p), scene_surface(vec3 p) -> Surface,
// scene_ray(vec2 uv, vec2 lens) -> Ray, scene_sky(vec3 direction, float spread) -> vec3, scene_light(int index, vec3 p) -> Light,
// scene_shadow(int index) -> int, LIGHT_COUNT and SHADOW_COUNT (shadowed lights come first). `block` is field::evaluate_frame's (literals are read
// from it). Deterministic. The result is also C++ of the dialect when there are no lists or frame values.
std::string print_scene(const graph::Program& program, std::span<const float> block, Placement placement);

// The fragment shader of the GPU device (`#version 330`): pictures into three buffers, or with layers into eight
// (shaders/gpu/main.glsl). `counts`: with the evaluations of the field.
std::string print_fragment_shader(const graph::Program& program, std::span<const float> block, Placement placement,
                                  bool layers = false, bool counts = false);
// The fragment shader that writes one distance per pixel (shaders/gpu/distances.glsl).
std::string print_distance_shader(const graph::Program& program, std::span<const float> block, Placement placement);

// A readable shader with the scene's constants in it; names from the document, made safe. target: "glsl" (a complete
// `#version 330` fragment shader with uniforms `resolution` and `time`) or "shadertoy".
std::string print_export(const graph::Program& program, const graph::Document& document, std::span<const float> block,
                         std::string_view target);
const std::vector<std::string>& export_targets();
// Why a program cannot be exported, as the end of a sentence; empty when it can.
std::string export_refusal(const graph::Program& program);
inline constexpr std::size_t export_list_limit = 8192;  // vectors: compilers are slow with constant arrays

}  // namespace fieldwright::codegen
