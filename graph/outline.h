// A closed outline: straight sides from point to point, and from the last back to the first.
#pragma once

#include "graph/value.h"

#include <optional>

namespace fieldwright::graph {

// Where two of its sides meet that are not neighbours, or a side runs back over the one before; nothing when it is
// simple. x and y of the points count. Looks at every pair of sides.
std::optional<glm::vec2> self_contact(const PointList& outline);

}  // namespace fieldwright::graph
