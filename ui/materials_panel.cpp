// Materials: what the surfaces are made of.
#include "ui/node_list.h"
#include "ui/panel_pages.h"

namespace fieldwright::ui {

void draw_materials_panel(FrameContext& frame, NodeList& materials)
{
    materials.draw(frame, "Materials",
                   "No materials yet. Select a shape and add one: it is painted on that shape. Without one, everything "
                   "is grey.");
}

}  // namespace fieldwright::ui
