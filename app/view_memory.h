// How the window was left: sizes of panes, and for each file the eye and the canvas. Kept in the window's state file.
#pragma once

#include "app/window_state.h"
#include "ui/view_state.h"

#include <filesystem>

namespace fieldwright::app {

void remember_panes(WindowState& state, const ui::ViewState& view);
void recall_panes(const WindowState& state, ui::ViewState& view);

void remember_view(WindowState& state, const std::filesystem::path& scene, const ui::ViewState& view);
// False, and nothing changed, when the scene was never seen.
bool recall_view(const WindowState& state, const std::filesystem::path& scene, ui::ViewState& view);

}  // namespace fieldwright::app
