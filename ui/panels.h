// Panels: the tabbed panels below the inspector.
#pragma once

#include "ui/node_list.h"
#include "ui/shader_panel.h"

namespace fieldwright::ui {

class Panels {
public:
    // Fills the current ImGui child window.
    void draw(FrameContext& frame);
    // A gesture is under way (a drag, a grab): what it changes is one step, recorded when it ends.
    bool busy() const { return false; }

private:
    void page(FrameContext& frame);

    NodeList materials_{"panel/materials", graph::SocketKind::material, "material"};
    NodeList lights_{"panel/lights", graph::SocketKind::light, "light"};
    NodeList cameras_{"panel/camera", graph::SocketKind::camera, "camera"};
    NodeList skies_{"panel/sky", graph::SocketKind::sky, "sky"};
    ShaderPanel shader_;
};

}  // namespace fieldwright::ui
