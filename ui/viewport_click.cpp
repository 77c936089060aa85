// What clicks on the picture do besides choosing nodes, and the hands on a slice and on the divider.
#include "ui/number_text.h"
#include "ui/viewport.h"
#include "ui/viewport_overlay.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float smallest_slice = 1e-3f, largest_slice = 1e4f;  // m, of its height

}  // namespace

glm::ivec2 Viewport::pixel_under(const FrameContext& frame, glm::vec2 at) const
{
    const PictureReading& picture = frame.readings.picture;
    glm::vec2 share = at / glm::max(pane_.high - pane_.low, glm::vec2(1));
    return glm::floor(share * glm::vec2(picture.width, picture.height));
}

void Viewport::click(FrameContext& frame, glm::vec2 at)
{
    ViewState& view = frame.view;
    if (view.view == "slice") return;
    if (view.click == Click::select) return choose_node(frame, at);
    glm::ivec2 pixel = pixel_under(frame, at);
    if (view.click == Click::inspect) {
        frame.requests.push_back(InspectRay{pixel.x, pixel.y});
        view.panel = Panel::field;
        return;
    }
    std::optional<float> depth = frame.readings.depth_at ? frame.readings.depth_at(pixel.x, pixel.y) : std::nullopt;
    if (!depth || *depth <= 0) {
        frame.draft.refusal = "there is only sky; click a surface to converge on it";
        return;
    }
    view.convergence = std::clamp(*depth, 0.01f, 10000.0f);
    view.click = Click::select;
}

void Viewport::move_slice(FrameContext& frame, glm::vec2 way_px)
{
    SliceView& slice = frame.view.slice;
    float metres_per_px = slice.height / std::max(pane_.high.y - pane_.low.y, 1.0f);
    slice.centre += metres_per_px * glm::vec2(-way_px.x, way_px.y);
}

// Of a slice, the point under the mouse stays where it is.
void Viewport::zoom(FrameContext& frame, float notches)
{
    if (frame.view.view != "slice") {
        leave_camera(frame);
        return frame.view.camera.dolly(notches);
    }
    SliceView& slice = frame.view.slice;
    glm::vec2 size = pane_.high - pane_.low, from_middle = (mouse_ - 0.5f * size) / std::max(size.y, 1.0f);
    float height = std::clamp(slice.height * std::pow(0.9f, notches), smallest_slice, largest_slice);
    slice.centre += (slice.height - height) * glm::vec2(from_middle.x, -from_middle.y);
    slice.height = height;
}

bool Viewport::has_divider(const FrameContext& frame) const
{
    const StereoChoice* mode = find_choice(frame.readings.stereo_modes, frame.view.stereo);
    return frame.view.eyes.split && mode && mode->mixes && has_stereo(frame.readings, frame.view);
}

float Viewport::divider_x(const FrameContext& frame) const
{
    return frame.view.eyes.divider * (pane_.high.x - pane_.low.x);
}

void Viewport::draw_divider(FrameContext& frame)
{
    if (!has_divider(frame)) return;
    const Theme& theme = frame.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    bool held = hot_divider_ || (grab_ && grab_->on == Grab::On::divider);
    float x = std::round(pane_.low.x + divider_x(frame)), middle = 0.5f * (pane_.low.y + pane_.high.y);
    ImU32 tint = held ? colour::hot : colour::text;
    list.AddRectFilled({x - theme.px(1), pane_.low.y}, {x + theme.px(1), pane_.high.y}, tint);
    list.AddCircleFilled({x, middle}, theme.px(10), colour::veil);
    list.AddCircle({x, middle}, theme.px(10), tint, 0, theme.px(1.5f));
    for (float side : {-1.0f, 1.0f})
        list.AddTriangleFilled({x + side * theme.px(7), middle}, {x + side * theme.px(3), middle - theme.px(3.5f)},
                               {x + side * theme.px(3), middle + theme.px(3.5f)}, tint);
    frame.rects.mark("viewport/divider", {{x - 6, middle - 6}, {x + 6, middle + 6}});
    if (held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

}  // namespace fieldwright::ui
