// A list of points: a picture whose points can be dragged, and a table.
#pragma once

#include "graph/library.h"
#include "ui/frame_context.h"

namespace fieldwright::ui {

enum class PointOrder { free, by_place };  // whether rows may change places

// The table alone; then with the picture. True in frames in which `points` changed. Spans the whole width. Marks `path`/<index>/x, /y, /delete, /up, /down,
// `path`/add, and `path`/picture/<index>.
bool points_table(FrameContext& frame, std::string_view path, const graph::Parameter& parameter,
                  graph::PointList& points, PointOrder order);
bool points_field(FrameContext& frame, std::string_view path, const graph::Parameter& parameter,
                  graph::PointList& points);

}  // namespace fieldwright::ui
