// Drawing the active node: its parameters, help and problems.
#include "ui/inspector.h"

namespace fieldwright::ui {

void Inspector::draw(FrameContext&) {}

}  // namespace fieldwright::ui
