// Where a line of a printed shader stands in the node files and the shading library it was made of.
#pragma once

#include "graph/library.h"

#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::codegen {

// "nodes/primitive/sphere.glsl:8"; nothing for lines that no file holds. Lines count from 1.
std::optional<std::string> place_of_line(const graph::Library& library, std::string_view shader, int line);
// A driver's complaint ("0:622(9): error: ...", "0(622) : error ...", "ERROR: 0:622: ...") with that place for its line.
std::string with_place(std::string complaint, const graph::Library& library, std::string_view shader);

}  // namespace fieldwright::codegen
