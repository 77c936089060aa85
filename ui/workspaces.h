// Workspaces: arrangements of the window for a kind of work. One holds as long as the window is as it asks for.
#pragma once

#include "ui/view_state.h"

#include <optional>
#include <span>

namespace fieldwright::ui {

struct Workspace {
    const char *id, *title, *help;
    bool with_panes = true;
    float canvas_share = 0;           // of the left column's height
    std::optional<Panel> panel = {};  // none: any
    const char* picture = "beauty";   // what the viewport shows

    bool holds(const ViewState& view) const;
    void arrange(ViewState& view) const;
};
std::span<const Workspace> workspaces();

}  // namespace fieldwright::ui
