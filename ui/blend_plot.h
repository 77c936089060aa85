// The plot of a smooth combiner: both distances, the result and its slope, where the two pass each other.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// Marks `path`, and `path`/slope.
void blend_plot(FrameContext& frame, std::string_view path, const BlendCurve& curve);

}  // namespace fieldwright::ui
