// The value of a parameter in a document.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <variant>
#include <vector>

namespace fieldwright::graph {

// Points of a list parameter: x, y (2D) and spare components, in the unit of the parameter.
using PointList = std::vector<glm::vec4>;

// number, angle (degrees): float. integer: int. choice, text, formula, image (path): std::string.
// colour: vec3, linear Rec.709. list: PointList.
using Value = std::variant<bool, int, float, glm::vec2, glm::vec3, std::string, PointList>;

}  // namespace fieldwright::graph
