// A context menu: a popup with rows of 24 px, and entries that show the shortcut of the command they stand for.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// While it lives.
struct ContextMenu {
    ContextMenu(const char* name, const Theme& theme);
    ~ContextMenu();
    ContextMenu(const ContextMenu&) = delete;
    ContextMenu& operator=(const ContextMenu&) = delete;
    bool open;
};

// True when it was chosen. `command`: the id of the command that does the same, or empty.
bool menu_item(FrameContext& frame, const char* name, const char* title, const char* command, bool enabled = true);

}  // namespace fieldwright::ui
