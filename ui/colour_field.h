// A colour: a swatch that opens a picker, and its sRGB hex word. The document's value is linear.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// True in frames in which `linear` changed. Marks `path`, `path`/hex and, while open, `path`/picker.
bool colour_field(FrameContext& frame, std::string_view path, std::string_view name, glm::vec3& linear, float width_px);
// A small square of the colour, to be drawn at `low`.
void draw_swatch(const FrameContext& frame, glm::vec3 linear, ImVec2 low, ImVec2 size);

}  // namespace fieldwright::ui
