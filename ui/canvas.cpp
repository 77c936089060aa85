// Drawing the node canvas: nodes, wires, and the hands on them.
#include "ui/canvas.h"

namespace fieldwright::ui {

void Canvas::draw(FrameContext&) {}

}  // namespace fieldwright::ui
