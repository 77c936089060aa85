// Fields for texts and formulas.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// As many lines as the text has; true in frames in which `text` changed.
bool text_field(const FrameContext& frame, const char* id, std::string& text, float width_px);
// One line in letters of one width; true in frames in which `text` changed.
bool formula_field(const FrameContext& frame, const char* id, std::string& text, float width_px);

}  // namespace fieldwright::ui
