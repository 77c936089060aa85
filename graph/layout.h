// Automatic layout: nodes in columns from left to right, what is made of them always further right.
#pragma once

#include "graph/edits.h"

#include <functional>
#include <map>

namespace fieldwright::graph {

using NodeSizes = std::function<glm::vec2(NodeId)>;  // px at zoom 1, both more than zero

// The column is the longest way to where nothing reads on, the order in it comes from four barycentre sweeps (after
// Sugiyama, Tagawa and Toda 1981). Deterministic; nothing overlaps; the left upper corner stays where it was. An empty
// set means all nodes; those of unknown type are left out. O((nodes + wires) log nodes).
std::map<NodeId, glm::vec2> layout(const Graph& graph, const std::set<NodeId>& nodes, const NodeSizes& size_px);
// More than half of the nodes lie exactly on another one, as in files that scripts write.
bool lies_in_heaps(const Graph& graph);
// Moves the nodes there.
Refusal arrange(Document& document, const std::set<NodeId>& nodes, const NodeSizes& size_px);

inline constexpr float layout_gap_x_px = 40, layout_gap_y_px = 24;

}  // namespace fieldwright::graph
