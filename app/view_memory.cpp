// Views as numbers under keys, and back.
#include "app/view_memory.h"

#include <algorithm>

namespace fieldwright::app {
namespace {

std::string key_of(const std::filesystem::path& scene) { return "view/" + scene.string() + "/"; }

// Visits every remembered number of a view with its key.
template <typename View, typename Visit>
void each_number(View& view, const Visit& visit)
{
    visit("pivot_x", view.camera.pivot.x);
    visit("pivot_y", view.camera.pivot.y);
    visit("pivot_z", view.camera.pivot.z);
    visit("yaw", view.camera.yaw_rad);
    visit("pitch", view.camera.pitch_rad);
    visit("distance", view.camera.distance);
    visit("pan_x", view.canvas.pan_px.x);
    visit("pan_y", view.canvas.pan_px.y);
    visit("zoom", view.canvas.zoom);
}

template <typename View, typename Visit>
void each_switch(View& view, const Visit& visit)
{
    visit("orthographic", view.camera.orthographic);
    visit("through_camera", view.through_camera);
}

}  // namespace

void remember_panes(WindowState& state, const ui::ViewState& view)
{
    state.remember("panes/side_width", view.panes.side_width);
    state.remember("panes/canvas_share", view.panes.canvas_share);
    state.remember("panes/inspector_share", view.panes.inspector_share);
    state.remember("panes/minimap", view.minimap ? 1.0 : 0.0);
    state.remember("panes/statistics", view.statistics ? 1.0 : 0.0);
    state.remember("panes/node_costs", view.node_costs ? 1.0 : 0.0);
    state.remember("stereo/screen_width", view.eyes.screen_width);
    state.remember("stereo/viewing_distance", view.eyes.viewing_distance);
    state.remember("reduced_motion", view.reduced_motion ? 1.0 : 0.0);
}

void recall_panes(const WindowState& state, ui::ViewState& view)
{
    auto share = [&](const char* key, float value) {
        return std::clamp(static_cast<float>(state.number(key, value)), 0.1f, 0.9f);
    };
    ui::Panes& panes = view.panes;
    panes.side_width =
        std::clamp(static_cast<float>(state.number("panes/side_width", panes.side_width)), 280.0f, 2000.0f);
    panes.canvas_share = share("panes/canvas_share", panes.canvas_share);
    panes.inspector_share = share("panes/inspector_share", panes.inspector_share);
    view.minimap = state.number("panes/minimap", view.minimap) != 0;
    view.statistics = state.number("panes/statistics", view.statistics) != 0;
    view.node_costs = state.number("panes/node_costs", view.node_costs) != 0;
    auto metres = [&](const char* key, float value) {
        return std::clamp(static_cast<float>(state.number(key, value)), 0.05f, 100.0f);
    };
    view.eyes.screen_width = metres("stereo/screen_width", view.eyes.screen_width);
    view.eyes.viewing_distance = metres("stereo/viewing_distance", view.eyes.viewing_distance);
    view.reduced_motion = state.number("reduced_motion", view.reduced_motion) != 0;
}

void remember_view(WindowState& state, const std::filesystem::path& scene, const ui::ViewState& view)
{
    std::string key = key_of(scene);
    each_number(view, [&](const char* name, float value) { state.remember(key + name, value); });
    each_switch(view, [&](const char* name, bool value) { state.remember(key + name, value ? 1.0 : 0.0); });
}

bool recall_view(const WindowState& state, const std::filesystem::path& scene, ui::ViewState& view)
{
    std::string key = key_of(scene);
    if (state.number(key + "zoom", 0) == 0) return false;
    each_number(view,
                [&](const char* name, float& value) { value = static_cast<float>(state.number(key + name, value)); });
    each_switch(view, [&](const char* name, bool& value) { value = state.number(key + name, value) != 0; });
    view.canvas.zoom = std::clamp(view.canvas.zoom, 0.1f, 4.0f);
    view.camera.distance = std::max(view.camera.distance, 1e-3f);
    return true;
}

}  // namespace fieldwright::app
