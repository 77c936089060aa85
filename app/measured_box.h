// The box around a node's surface, by its own bounds functions.
#pragma once

#include "graph/program.h"
#include "ui/readings.h"

namespace fieldwright::app {

// In the node's own space, the whole scene's for NodeId{}. Nothing for nodes that are no field. Time 0.
std::optional<ui::Measured> measured_box(const graph::Document& document,
                                         const std::shared_ptr<const graph::Library>& library,
                                         const graph::BakedImages& images, graph::SlopeMemo& slopes,
                                         graph::NodeId node);

}  // namespace fieldwright::app
