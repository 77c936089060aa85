// What lies over the picture and is no part of it: toolbar, statistics, and the legend of the steps view.
#pragma once

#include "ui/frame_context.h"

#include <string>

namespace fieldwright::ui {

class Viewport;

// Top left of the pane; real widgets.
void draw_toolbar(FrameContext& frame, Viewport& viewport, const WidgetRect& pane);
// Bottom left: how the picture was made, and that a shader is on its way; a line along the bottom while it refines.
void draw_statistics(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);
// Bottom right: what the colours of the steps view mean.
void draw_steps_legend(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);
// In the middle, while there is no picture.
void draw_waiting(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);

// "1280 × 720 · cpu · 24 ms · 31 steps mean, 256 max · 0.2 % out of steps"
std::string statistics_text(const PictureReading& picture);
std::string short_statistics_text(const PictureReading& picture);  // up to the time, for narrow panes
bool has_stereo(std::string_view view);             // the colours of the others are data, which glasses would falsify
std::string view_words(std::string_view view);      // of `ViewState::view`: "Steps heatmap"
std::string stereo_words(std::string_view stereo);  // of `ViewState::stereo`: "Dubois anaglyph"
// Whether what is drawn changes while time passes.
bool depends_on_time(const Readings& readings);
ImU32 heatmap(float share);  // as in shaders/render/views.glsl

}  // namespace fieldwright::ui
