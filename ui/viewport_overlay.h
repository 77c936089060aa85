// What lies over the picture and is no part of it: toolbar, statistics, and the legend of numbers.
#pragma once

#include "ui/frame_context.h"

#include <string>

namespace fieldwright::ui {

class Viewport;

// Top left of the pane; real widgets.
void draw_toolbar(FrameContext& frame, Viewport& viewport, const WidgetRect& pane);
// Bottom left: how the picture was made, and that a shader is on its way; a line along the bottom while it refines.
void draw_statistics(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);
// Bottom right: what the colours of a view of numbers mean.
void draw_legend(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);
// In the middle, while there is no picture.
void draw_waiting(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);

// "1280 × 720 · cpu · 24 ms · 31 steps mean, 256 max · 0.2 % out of steps"
std::string statistics_text(const PictureReading& picture);
std::string short_statistics_text(const PictureReading& picture);  // up to the time, for narrow panes
// Whether both eyes are drawn: of a view whose colours are data, glasses would falsify them.
bool has_stereo(const Readings& readings, const ViewState& view);

}  // namespace fieldwright::ui
