// Drawing the tabbed panels below the inspector.
#include "ui/panels.h"

namespace fieldwright::ui {

void Panels::draw(FrameContext&) {}

}  // namespace fieldwright::ui
