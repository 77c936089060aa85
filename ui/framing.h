// What the eye is moved to see: boxes in the world around nodes.
#pragma once

#include "ui/frame_context.h"

#include <span>

namespace fieldwright::ui {

// Around what these nodes show, or the whole scene when there are none. What has no end (a ground) is left out while
// something else is there; alone it counts with 3 m.
Measured box_to_frame(const FrameContext& frame, std::span<const graph::NodeId> nodes);

}  // namespace fieldwright::ui
