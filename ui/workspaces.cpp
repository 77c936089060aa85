// The workspaces, and arranging them.
#include "ui/workspaces.h"

namespace fieldwright::ui {
namespace {

constexpr Workspace list[] = {
    {.id = "build",
     .title = "Build",
     .help = "Arranges the window for wiring nodes: a large canvas.",
     .canvas_share = Panes{}.canvas_share},
    {.id = "shade",
     .title = "Shade",
     .help = "Arranges the window for colours: a large picture, and the materials.",
     .canvas_share = 0.25f,
     .panel = Panel::materials},
    {.id = "inspect",
     .title = "Inspect",
     .help = "Arranges the window to see what the scene costs: steps as colours, and numbers.",
     .canvas_share = 0.25f,
     .panel = Panel::cost,
     .picture = "steps"},
    {.id = "present", .title = "Present", .help = "Shows the picture alone.", .with_panes = false},
};

}  // namespace

std::span<const Workspace> workspaces() { return list; }

bool Workspace::holds(const ViewState& view) const
{
    if (view.panes.shown != with_panes || view.view != picture) return false;
    return !with_panes || (view.panes.canvas_share == canvas_share && (!panel || view.panel == *panel));
}

void Workspace::arrange(ViewState& view) const
{
    view.panes.shown = with_panes;
    view.view = picture;
    if (!with_panes) return;
    view.panes.canvas_share = canvas_share;
    if (panel) view.panel = *panel;
}

}  // namespace fieldwright::ui
