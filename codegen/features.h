// What of the shading library a program needs: structure, so what a scene does not use is not in its shader's text.
#pragma once

#include "graph/program.h"
#include "graph/shader_parts.h"

#include <span>

namespace fieldwright::codegen {

struct Features {
    bool microfacets = false;     // a material has them
    bool reflection = false;      // materials know what they mirror and let through
    bool bounces = false;         // and rays follow it
    bool transmission = false;    // a material lets light through
    bool tinted_shadows = false;  // and shadow rays follow it
    bool lens = false;            // the camera has one
    bool fog = false;
    bool bisects = false;   // walks by constant steps
    bool cones = false;     // rays keep their smallest ratio of distance and way
    bool coverage = false;  // the edges of eye rays are looked for
    bool layers = false;    // asked for by who draws
    bool counts = false;    // so are evaluations of the field; with layers they are there
};

// `block` is field::evaluate_frame's: a mirror that mirrors nothing is none.
Features features_of(const graph::Program& program, std::span<const float> block, bool layers = false,
                     bool counts = false);
// A comment that names the parts that a shader's text has, and what it names.
std::string parts_comment(const graph::ShaderParts& parts);
graph::ShaderParts parts_of_shader(std::string_view shader);
// Names of the parts of the shading library's texts.
graph::ShaderParts shader_parts(const Features& features);

}  // namespace fieldwright::codegen
