// Where a node's surface stands in the world: what its readers on the way to the output do to its space.
#pragma once

#include "graph/document.h"
#include "graph/library.h"
#include "ui/readings.h"

#include <optional>

namespace fieldwright::ui {

// world = linear * p_node + offset
struct Placement {
    glm::mat3 linear{1};  // a rotation times a size
    glm::vec3 offset{0};  // m
    glm::vec3 world_from_node(glm::vec3 p_node) const { return linear * p_node + offset; }
};

inline constexpr float unbounded = 1e6f;  // m; a half size of it has no end

// Along a way to the output on which every node moves, turns or scales by a stored value, or leaves space as it is;
// nothing when there is no such way. Of several, as for a shared node, the one by the first inputs. Of a node
// in groups, that of its first copy.
std::optional<Placement> placement(const graph::Document& document, const graph::Library& library, graph::NodeId node);

// The box in the world around what a box in a node's space holds.
Measured placed(const Placement& place, const Measured& box);

}  // namespace fieldwright::ui
