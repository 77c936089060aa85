// A drawing: a canvas of cells to paint on with the mouse, and what it is painted with.
#pragma once

#include "graph/library.h"
#include "ui/frame_context.h"

namespace fieldwright::ui {

// Edits the rectangles and the number of cells of a drawn node; one stroke is one step. Spans the whole width. Marks
// `path`/canvas, /tool/paint /erase /line /rectangle, /mirror, /clear, /invert, /finer and /coarser.
void drawing_field(FrameContext& frame, std::string_view path, graph::NodeId node, const graph::Parameter& parameter);

// "12 rectangles of 61 cells".
std::string drawing_words(const graph::Node& node, const graph::PointList& rectangles);

}  // namespace fieldwright::ui
