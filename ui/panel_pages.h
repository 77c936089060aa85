// The panels that keep nothing between frames: each fills what is left of the current ImGui window.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

class NodeList;

void draw_materials_panel(FrameContext& frame, NodeList& materials);
void draw_lights_panel(FrameContext& frame, NodeList& lights);
void draw_camera_panel(FrameContext& frame, NodeList& cameras, NodeList& skies);
void draw_cost_panel(FrameContext& frame);
void draw_field_panel(FrameContext& frame);
void draw_stereo_panel(FrameContext& frame);
void draw_problems_panel(FrameContext& frame);
void draw_history_panel(FrameContext& frame);

}  // namespace fieldwright::ui
