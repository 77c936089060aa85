// Drawing the picture, the eye that sees it, and what is drawn over it.
#include "ui/viewport.h"

namespace fieldwright::ui {

void Viewport::draw(FrameContext&) {}

}  // namespace fieldwright::ui
