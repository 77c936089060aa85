// The scene's own numbers: how rays march and bounce, occlusion, and fog.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// Rows of every setting. Marks `path`/<setting> and `path`/<setting>/reset.
void scene_settings(FrameContext& frame, std::string_view path);

}  // namespace fieldwright::ui
