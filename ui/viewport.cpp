// Drawing the picture and what lies over it, and the hands on them.
#include "ui/viewport.h"

#include "ui/scene_camera.h"
#include "ui/slice_frame.h"
#include "ui/transport.h"
#include "ui/viewport_empty.h"
#include "ui/viewport_overlay.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

using Handle = TranslateGizmo::Handle;

constexpr float click_px = 3;                            // a press that moves less is a click; design px
constexpr float turn_per_px = 0.0075f;                   // rad, per design px
constexpr float divider_reach_px = 6;                    // either side, design px
constexpr float px_per_notch = 20;                       // of a dolly drag, design px
constexpr float axes_inset_px = 56, axes_room_px = 200;  // the axis gizmo's centre from the corner; least pane

ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }
glm::vec2 vec(ImVec2 v) { return {v.x, v.y}; }

// Whether a place of the picture is a direction of the eye: not on a slice, and not where two pictures share the pane.
bool shows_space(const FrameContext& frame)
{
    if (frame.view.view == "slice") return false;
    const StereoChoice* mode = find_choice(frame.readings.stereo_modes, frame.view.stereo);
    return !mode || mode->across * mode->down == 1;
}

}  // namespace

void Viewport::draw(FrameContext& frame)
{
    scale_ = frame.theme.scale;
    pane_ = {vec(ImGui::GetWindowPos()), vec(ImGui::GetWindowPos()) + vec(ImGui::GetWindowSize())};
    has_mouse_ = ImGui::IsMousePosValid();
    if (has_mouse_) mouse_ = vec(ImGui::GetIO().MousePos) - pane_.low;
    frame.rects.mark("viewport", pane_);
    follow_motion(frame);
    draw_picture(frame);
    place_handles(frame);
    hands(frame);
    draw_handles(frame);
    draw_divider(frame);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_slice_overlay(frame, list, pane_);
    WidgetRect above{pane_.low, {pane_.high.x, pane_.high.y - transport_height(frame)}};
    draw_statistics(frame, list, above);
    draw_legend(frame, list, above);
    draw_transport(frame, pane_);
    draw_toolbar(frame, *this, pane_);
    if (frame.readings.picture.texture) draw_nothing_to_see(frame, pane_);
    draw_projection(frame);
}

void Viewport::draw_picture(const FrameContext& frame) const
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (frame.readings.picture.texture) list.AddImage(frame.readings.picture.texture, im(pane_.low), im(pane_.high));
    else draw_waiting(frame, list, pane_);
}

void Viewport::place_handles(FrameContext& frame)
{
    glm::vec2 size = pane_.high - pane_.low;
    std::optional<ViewCamera> eye = shows_space(frame) ? shown_eye(frame) : std::nullopt;
    axes_shown_ = eye && std::min(size.x, size.y) >= frame.theme.px(axes_room_px);
    glm::vec2 inset = frame.theme.px(axes_inset_px) * glm::vec2(1, 1);
    if (axes_shown_) axes_.place({pane_.high.x - inset.x, pane_.low.y + inset.y}, *eye, frame.theme);
    bool with_gizmo = eye && frame.view.gizmo;
    if (with_gizmo) gizmo_.place(frame, *eye, size), sun_.place(frame, *eye, size);
    else gizmo_.hide(), sun_.hide();
}

void Viewport::hands(FrameContext& frame)
{
    ImGui::SetCursorScreenPos(im(pane_.low));
    ImGui::InvisibleButton("hands", im(pane_.high - pane_.low),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight | static_cast<int>(ImGuiButtonFlags_AllowItemOverlap));
    ImGui::SetItemAllowOverlap();
    bool was_hovered = hovered_;
    on_picture_ = ImGui::IsItemHovered();
    hovered_ = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (!grab_) {
        hot_axes_ = on_picture_ && axes_shown_ && axes_.contains(pane_.low + mouse_);
        hot_sun_ = on_picture_ && !hot_axes_ && sun_.is_under(mouse_, frame.theme);
        hot_ = on_picture_ && !hot_axes_ ? gizmo_.handle_at(mouse_, frame.theme) : Handle::none;
        float reach = frame.theme.px(divider_reach_px);
        hot_divider_ = on_picture_ && has_divider(frame) && std::abs(mouse_.x - divider_x(frame)) <= reach;
    }
    if (hovered_ && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) frame.view.click = Click::select;
    if (ImGui::IsItemActivated()) press(ImGui::GetCurrentContext()->ActiveIdMouseButton);
    if (grab_ && ImGui::IsItemActive()) drag(frame);
    else if (grab_) release(frame);
    if (on_picture_ && !grab_ && ImGui::GetIO().MouseWheel != 0) {
        zoom(frame, ImGui::GetIO().MouseWheel);
    }
    if (hovered_ || was_hovered) frame.view.hint = hovered_ ? hint(frame) : "";
}

void Viewport::press(int button)
{
    const ImGuiIO& io = ImGui::GetIO();
    Turn turn = Turn::orbit;
    if (button == 1 || io.KeyCtrl) turn = Turn::dolly;
    else if (io.KeyShift || (io.KeyAlt && button == 2)) turn = Turn::pan;
    if (button == 1 && !io.KeyAlt) return;
    Grab::On on = Grab::On::picture;
    if (button == 0 && hot_axes_) on = Grab::On::axes, turn = Turn::orbit;
    if (button == 0 && hot_ != Handle::none) on = Grab::On::handle, gizmo_.grab(hot_, mouse_);
    if (button == 0 && hot_sun_) on = Grab::On::sun, sun_.grab(mouse_);
    if (button == 0 && hot_divider_) on = Grab::On::divider;
    grab_ = Grab{on, turn, button, mouse_, mouse_};
}

void Viewport::drag(FrameContext& frame)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) gizmo_.cancel(frame), sun_.cancel(frame);
    if (!grab_->moved && glm::distance(mouse_, grab_->from) <= click_px * scale_) return;
    grab_->moved = true;
    glm::vec2 way = mouse_ - grab_->last;
    grab_->last = mouse_;
    if (grab_->on == Grab::On::handle) gizmo_.drag(frame, {mouse_, io.KeyCtrl, io.KeyShift});
    else if (grab_->on == Grab::On::sun) sun_.drag(frame, {mouse_, io.KeyCtrl, io.KeyShift});
    else if (grab_->on == Grab::On::divider)
        frame.view.eyes.divider = std::clamp(mouse_.x / std::max(pane_.high.x - pane_.low.x, 1.0f), 0.0f, 1.0f);
    else if (frame.view.view == "slice") move_slice(frame, way);
    else if (way != glm::vec2(0)) turn_eye(frame, grab_->turn, way);
}

void Viewport::release(FrameContext& frame)
{
    Grab grab = *grab_;
    grab_.reset();
    gizmo_.let_go();
    sun_.let_go();
    if (grab.moved || grab.button != 0 || !has_mouse_) return;  // without a mouse: the window lost it
    if (grab.on == Grab::On::picture) click(frame, grab.from);
    if (grab.on != Grab::On::axes) return;
    std::optional<Side> side = axes_.side_at(pane_.low + grab.from);
    if (!side) return;
    bool there = frame.view.camera.looks_along(side->axis, side->sign) && !looks_through_camera(frame);
    look_along(frame, side->axis, there ? -side->sign : side->sign);
}

void Viewport::turn_eye(FrameContext& frame, Turn turn, glm::vec2 way_px)
{
    leave_camera(frame);
    ViewCamera& eye = frame.view.camera;
    if (turn == Turn::orbit) {
        leave_axis_view(frame);
        eye.orbit(turn_per_px / scale_ * way_px);
    }
    if (turn == Turn::pan) eye.pan(way_px, pane_.high.y - pane_.low.y);
    if (turn == Turn::dolly) eye.dolly((way_px.x - way_px.y) / (px_per_notch * scale_));
}

graph::NodeId Viewport::node_under(const FrameContext& frame, glm::vec2 at) const
{
    const PictureReading& picture = frame.readings.picture;
    if (!picture.texture || !frame.readings.node_at) return {};
    glm::ivec2 pixel = pixel_under(frame, at);
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture.width || pixel.y >= picture.height) return {};
    graph::NodeId node = frame.readings.node_at(pixel.x, pixel.y);
    return frame.draft.document.root.find(node) ? node : graph::NodeId{};
}

void Viewport::choose_node(FrameContext& frame, glm::vec2 at)
{
    const ImGuiIO& io = ImGui::GetIO();
    Selection& selection = frame.view.selection;
    graph::NodeId node = node_under(frame, at);
    if (node && io.KeyCtrl) selection.toggle(node);
    else if (node && io.KeyShift) selection.add(node);
    else if (node) selection.only(node);
    else if (!io.KeyCtrl && !io.KeyShift) selection.clear();
}

std::string Viewport::hint(const FrameContext& frame) const
{
    if (!on_picture_ && !grab_) return "";
    if (hot_ == Handle::centre) return "Drag to move in the plane of the view. Ctrl snaps to 0.1 m, Shift is fine.";
    if (hot_ != Handle::none) return "Drag to move along this axis. Ctrl snaps to 0.1 m, Shift is fine.";
    if (hot_sun_) return "Drag to turn the sun. Ctrl snaps to 5°, Shift is fine.";
    if (hot_axes_) return "Drag to orbit, click a ball to look along its axis.";
    if (hot_divider_) return "Drag: the plain anaglyph is left of it.";
    if (frame.view.view == "slice") return slice_hint(frame, mouse_, pane_.high - pane_.low);
    if (grab_) return "";
    if (frame.view.click == Click::converge)
        return "Click what is to appear in the plane of the screen. Esc leaves it.";
    if (frame.view.click == Click::inspect) return "Click where the ray that is inspected goes. Esc leaves it.";
    const graph::Node* node = frame.draft.document.root.find(node_under(frame, mouse_));
    const graph::NodeType* type = node ? frame.draft.library.type(node->type) : nullptr;
    if (!node) return "Drag to orbit, Shift-drag to pan, scroll to come closer.";
    std::string title = type ? type->title : node->type;
    return (node->name.empty() ? title : node->name + " · " + title) + ". Click to select.";
}

void Viewport::draw_handles(FrameContext& frame)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(im(pane_.low), im(pane_.high), true);
    Handle held = gizmo_.grabbed();
    gizmo_.draw(list, pane_.low, held == Handle::none ? hot_ : held, frame);
    sun_.draw(list, pane_.low, hot_sun_, frame);
    if (axes_shown_) axes_.draw(list, pane_.low + mouse_, hot_axes_, frame);
    list.PopClipRect();
}

// Under the axis gizmo: what kind of eye this is; pressed, it becomes the other kind.
void Viewport::draw_projection(FrameContext& frame)
{
    if (!axes_shown_) return;
    bool through = looks_through_camera(frame);
    const char* text = through ? "Scene camera" : frame.view.camera.orthographic ? "Orthographic" : "Perspective";
    ImGui::PushFont(frame.theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Button, colour::with_alpha(colour::window, 0.6f));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {frame.theme.px(6), frame.theme.px(2)});
    float width = ImGui::CalcTextSize(text).x + frame.theme.px(12), inset = frame.theme.px(axes_inset_px);
    ImGui::SetCursorScreenPos({std::round(pane_.high.x - inset - 0.5f * width), pane_.low.y + frame.theme.px(104)});
    if (ImGui::Button((std::string(text) + "###projection").c_str()))
        through ? look_through_camera(frame) : toggle_orthographic(frame);
    frame.rects.mark("viewport/projection");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace fieldwright::ui
