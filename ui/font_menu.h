// The list of installed fonts beside a field for one: searched by name, chosen with a click.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// A button that opens the list; what was chosen in this frame, "" for the built-in font. `chosen` is the font now.
std::optional<std::string> font_menu(FrameContext& frame, const std::string& path, const std::string& chosen);

}  // namespace fieldwright::ui
