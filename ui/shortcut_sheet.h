// The sheet of all shortcuts, in columns by menu.
#pragma once

#include "ui/commands.h"

namespace fieldwright::ui {

class ShortcutSheet {
public:
    void open() { asked_ = true; }  // shown when it is next drawn; closed by Escape, F1 or a click beside it
    void draw(FrameContext& frame, std::span<const Command> commands);

private:
    bool asked_ = false;
};

}  // namespace fieldwright::ui
