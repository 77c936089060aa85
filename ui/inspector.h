// Inspector: the active node: its parameters, help and problems.
#pragma once

#include "ui/group_interface.h"
#include "ui/own_type_panel.h"

namespace fieldwright::ui {

class Inspector {
public:
    // Fills the current ImGui child window.
    void draw(FrameContext& frame);
    // A gesture is under way (a drag, a grab): what it changes is one step, recorded when it ends.
    bool busy() const { return false; }

private:
    void active_node(FrameContext& frame, graph::NodeId id);

    OwnTypePanel own_type_;
    GroupInterface interface_;
};

}  // namespace fieldwright::ui
