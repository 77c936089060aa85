// The profile of a smooth combiner: what its own function makes of two distances that pass each other.
#pragma once

#include "graph/program.h"
#include "ui/readings.h"

namespace fieldwright::app {

// With the parameters it has in the program at a time. Nothing for a node that has no `smoothness`, that the program does
// not call, or whose parameters vary over space.
std::optional<ui::BlendCurve> blend_curve(const graph::Program& program, const graph::NodeType& type,
                                          graph::NodeId node, float time_s);

}  // namespace fieldwright::app
