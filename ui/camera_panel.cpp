// Camera and sky: the eye of the scene, what it sees behind everything, and the view's own eye.
#include "ui/node_list.h"
#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include "graph/scene_parts.h"

#include <glm/trigonometric.hpp>

namespace fieldwright::ui {
namespace {

graph::SceneView scene_view(const ViewCamera& camera)
{
    graph::SceneView view{.position = camera.position(),
                          .target = camera.pivot,
                          .field_of_view_deg = glm::degrees(camera.field_of_view_rad)};
    if (camera.orthographic) view.height = camera.height_at_pivot();
    return view;
}

void set_from_view(FrameContext& frame)
{
    graph::Placed placed =
        graph::set_scene_camera_from_view(frame.draft.document, frame.draft.library, scene_view(frame.view.camera));
    if (frame.draft.done("Set camera from view", placed.refusal)) frame.view.selection.only(placed.node);
}

}  // namespace

void draw_camera_panel(FrameContext& frame, NodeList& cameras, NodeList& skies)
{
    const Theme& theme = frame.theme;
    bool through = frame.view.through_camera && frame.readings.has_camera;
    ImGui::BeginDisabled(!frame.readings.has_camera);
    begin_row(frame, "Look through", "Whose eye the viewport uses: the scene's camera or its own.");
    std::string shown = through ? "camera" : "own";
    if (segments(frame, "panel/camera/view", {{"camera", "Camera"}, {"own", "Own view"}}, shown))
        frame.view.through_camera = shown == "camera";
    ImGui::EndDisabled();
    if (text_button(frame, "from view", std::string(icon::camera) + "  Set camera from view",
                    ImGui::GetContentRegionAvail().x))
        set_from_view(frame);
    frame.rects.mark("panel/camera/from_view");
    tooltip(frame, "Moves the scene's camera to where the viewport's own view looks from.");
    ImGui::Dummy({0, theme.gap()});
    cameras.draw(frame, "Cameras", "No camera. Turn the view as you like it, then set the camera from it.");
    ImGui::Dummy({0, theme.gap()});
    skies.draw(frame, "Skies", "No sky: what is behind everything stays black.");
}

}  // namespace fieldwright::ui
