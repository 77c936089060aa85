// Inspector: the active node: its parameters, help and problems.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

class Inspector {
public:
    // Fills the current ImGui child window.
    void draw(FrameContext& frame);
    // A gesture is under way (a drag, a grab): what it changes is one step, recorded when it ends.
    bool busy() const { return false; }
};

}  // namespace fieldwright::ui
