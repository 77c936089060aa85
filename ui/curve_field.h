// The editor of a curve through points: a plot whose points are dragged, added and removed, and a table.
#pragma once

#include "graph/document.h"
#include "graph/library.h"
#include "ui/frame_context.h"

namespace fieldwright::ui {

// `node` is of the type `curve`. True in frames in which `points` changed; they come back in order. Marks `path`/curve,
// `path`/curve/<index>, and what the table of points marks.
bool curve_field(FrameContext& frame, std::string_view path, const graph::Node& node, const graph::Parameter& parameter,
                 graph::PointList& points);

}  // namespace fieldwright::ui
