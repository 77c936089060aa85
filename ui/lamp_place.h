// Where a new lamp lights what is seen: in front of it, above it and to the left, as bright as suits the light there is.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// Gives a node just added to `document` that place and strength; other nodes than lamps, which have both, stay.
void place_lamp(const FrameContext& frame, graph::Document& document, graph::NodeId node);

}  // namespace fieldwright::ui
