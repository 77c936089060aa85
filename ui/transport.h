// The scene's time as frames of its animation: playing on, stepping, and the bar below the picture.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// Whether what is drawn changes while time passes.
bool depends_on_time(const Readings& readings);

int shown_frame(const graph::AnimationSettings& animation, double time_s);  // the nearest
void go_to_frame(ViewState& view, const graph::AnimationSettings& animation, int frame);
// From the last frame to the first and back, when it loops.
void step_frames(ViewState& view, const graph::AnimationSettings& animation, int steps);
// What plays goes on by whole frames; at the end it begins again or stops.
void play_on(ViewState& view, const graph::AnimationSettings& animation, double passed_s);

float transport_height(const FrameContext& frame);  // px; 0 when nothing depends on time
// At the bottom of the pane.
void draw_transport(FrameContext& frame, const WidgetRect& pane);

}  // namespace fieldwright::ui
