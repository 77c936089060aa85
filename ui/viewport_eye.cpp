// Moving the viewport's eye: the views that commands ask for, and the way there.
#include "graph/scene_parts.h"
#include "ui/framing.h"
#include "ui/scene_camera.h"
#include "ui/viewport.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float motion_s = 0.15f;
constexpr float parallel_from = 50;  // m from the pivot

// In front of what there is, and not so far that the march ends before it.
float rays_from(const FrameContext& frame) { return std::min(parallel_from, 0.5f * frame.draft.document.march.far); }

}  // namespace

// Whose picture is shown; nothing when that is a camera only the program can follow.
std::optional<ViewCamera> Viewport::shown_eye(const FrameContext& frame) const
{
    if (!looks_through_camera(frame)) return frame.view.camera;
    std::optional<SceneCamera> camera = scene_camera(frame.draft.document);
    return camera && !camera->driven && !camera->bent ? std::optional(camera->eye) : std::nullopt;
}

bool Viewport::looks_through_camera(const FrameContext& frame) const
{
    return frame.view.through_camera && (frame.readings.has_camera || scene_camera(frame.draft.document));
}

void Viewport::leave_camera(FrameContext& frame)
{
    motion_.reset();
    if (!frame.view.through_camera) return;
    if (std::optional<SceneCamera> camera = scene_camera(frame.draft.document)) frame.view.camera = camera->eye;
    frame.view.through_camera = perspective_before_axis_view_ = false;
}

ViewCamera Viewport::destination(const FrameContext& frame) const { return motion_ ? motion_->to : frame.view.camera; }

void Viewport::go_to(FrameContext& frame, const ViewCamera& eye)
{
    if (frame.view.reduced_motion) frame.view.camera = eye, motion_.reset();
    else motion_ = Motion{frame.view.camera, eye};
}

void Viewport::follow_motion(FrameContext& frame)
{
    if (!motion_) return;
    motion_->seconds += ImGui::GetIO().DeltaTime;
    float rest = 1 - std::min(motion_->seconds / motion_s, 1.0f);
    frame.view.camera = motion_->from.towards(motion_->to, 1 - rest * rest * rest);
    if (rest == 0) motion_.reset();
}

void Viewport::frame_box(FrameContext& frame, const Measured& box)
{
    ViewCamera eye = motion_ ? motion_->to : frame.view.camera;
    if (frame.view.through_camera) leave_camera(frame), eye = frame.view.camera;
    glm::vec2 size = glm::max(pane_.high - pane_.low, glm::vec2(1));
    eye.frame(box.centre, box.half_size, size.x / size.y);
    go_to(frame, eye);
}

void Viewport::frame_all(FrameContext& frame) { frame_box(frame, box_to_frame(frame, {})); }

void Viewport::frame_selected(FrameContext& frame)
{
    frame_box(frame, box_to_frame(frame, frame.view.selection.nodes()));
}

void Viewport::look_along(FrameContext& frame, int axis, int side)
{
    ViewCamera eye = destination(frame);
    if (frame.view.through_camera) leave_camera(frame), eye = frame.view.camera;
    perspective_before_axis_view_ = perspective_before_axis_view_ || !eye.orthographic;
    eye.look_along(axis, side);
    eye.rays_from = rays_from(frame);
    go_to(frame, eye);
}

// An axis view is parallel for as long as it is looked along its axis.
void Viewport::leave_axis_view(FrameContext& frame)
{
    if (std::exchange(perspective_before_axis_view_, false)) frame.view.camera.orthographic = false;
}

void Viewport::orbit(FrameContext& frame, glm::vec2 turn_rad)
{
    ViewCamera eye = destination(frame);
    if (frame.view.through_camera) leave_camera(frame), eye = frame.view.camera;
    if (std::exchange(perspective_before_axis_view_, false)) eye.orthographic = false;
    eye.orbit(turn_rad);
    go_to(frame, eye);
}

void Viewport::toggle_orthographic(FrameContext& frame)
{
    if (motion_) frame.view.camera = motion_->to;
    leave_camera(frame);
    perspective_before_axis_view_ = false;
    frame.view.camera.toggle_orthographic();
    frame.view.camera.rays_from = rays_from(frame);
}

void Viewport::look_through_camera(FrameContext& frame)
{
    if (looks_through_camera(frame)) return leave_camera(frame);
    frame.view.through_camera = frame.readings.has_camera || scene_camera(frame.draft.document);
    if (!frame.view.through_camera) frame.draft.refusal = "the scene has no camera; add one and wire it to the output";
}

void Viewport::set_camera_from_view(FrameContext& frame)
{
    if (looks_through_camera(frame)) {
        frame.draft.refusal = "the view is the camera's already; orbit or pan first";
        return;
    }
    ViewCamera eye = destination(frame);
    graph::SceneView seen{eye.position(), eye.pivot, glm::degrees(eye.field_of_view_rad), {}};
    if (eye.orthographic) seen.height = eye.height_at_pivot();
    graph::Placed camera = graph::set_scene_camera_from_view(frame.draft.document, frame.draft.library, seen);
    if (!frame.draft.done("Set camera from view", camera.refusal)) return;
    motion_.reset();
    frame.view.camera = eye;
    frame.view.through_camera = true;
}

void Viewport::toggle_gizmo(FrameContext& frame) { frame.view.gizmo = !frame.view.gizmo; }

}  // namespace fieldwright::ui
