// A shader tried out: compiled, linked and drawn for one pixel. For a process that may die of it.
#pragma once

#include <string>

namespace fieldwright::renderer {

// The driver's words about a fragment shader it refuses, in full; empty when it takes it. graph::Failure{4} without GL.
std::string shader_log(const std::string& fragment_text);

}  // namespace fieldwright::renderer
