// Why there is nothing to see, over the picture, and the button that helps.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

void draw_nothing_to_see(FrameContext& frame, const WidgetRect& pane);

}  // namespace fieldwright::ui
