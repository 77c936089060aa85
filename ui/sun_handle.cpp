// Dragging the sun's ball over a sphere, and drawing it.
#include "ui/sun_handle.h"

#include "graph/known_types.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

namespace known_types = graph::known_types;

constexpr float arrow_px = 110, ball_px = 10, reach_px = 14;  // design px
constexpr float snap_deg = 5, fine_share = 0.1f;

ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }

float snapped(float angle_deg) { return snap_deg * std::round(angle_deg / snap_deg); }

// The same direction, by less than half a turn away.
float nearest_turn(float angle_deg, float to_deg)
{
    float turned = angle_deg + 360 * std::round((to_deg - angle_deg) / 360);
    return std::abs(turned) <= 360 ? turned : angle_deg;
}

std::string step_name(const Draft& draft, graph::NodeId id)
{
    const graph::Node* node = draft.document.root.find(id);
    return "Turn " + (node && !node->name.empty() ? node->name : std::string("sun"));
}

}  // namespace

glm::vec3 sun_direction(float elevation_deg, float azimuth_deg)
{
    float elevation = glm::radians(elevation_deg), azimuth = glm::radians(azimuth_deg);
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

std::optional<SunHandle::Angles> SunHandle::angles_of(const graph::Node& node)
{
    const graph::Value *elevation = node.parameter(known_types::sun_elevation),
                       *azimuth = node.parameter(known_types::sun_azimuth);
    const float *up = elevation ? std::get_if<float>(elevation) : nullptr,
                *around = azimuth ? std::get_if<float>(azimuth) : nullptr;
    bool driven = node.input(known_types::sun_elevation) || node.input(known_types::sun_azimuth);
    return up && around && !driven ? std::optional(Angles{*up, *around}) : std::nullopt;
}

void SunHandle::place(const FrameContext& frame, const ViewCamera& eye, glm::vec2 pane_size_px)
{
    eye_ = eye;
    pane_size_px_ = pane_size_px;
    length_px_ = frame.theme.px(arrow_px);
    const graph::Node* node = frame.draft.document.root.find(frame.view.selection.active());
    std::optional<Angles> angles =
        node && node->type == known_types::sun && !node->muted ? angles_of(*node) : std::nullopt;
    if (!angles || (sun_ && sun_ != node->id)) let_go();
    sun_ = angles ? node->id : graph::NodeId{};
    if (angles) angles_ = *angles;
}

void SunHandle::hide()
{
    sun_ = {};
    let_go();
}

float SunHandle::metres() const { return eye_.height_at(eye_.pivot) * length_px_ / std::max(pane_size_px_.y, 1.0f); }

glm::vec3 SunHandle::ball() const
{
    return eye_.pivot + metres() * sun_direction(angles_.elevation_deg, angles_.azimuth_deg);
}

bool SunHandle::is_under(glm::vec2 at_px, const Theme& theme) const
{
    auto at = sun_ ? eye_.project(ball(), pane_size_px_) : std::nullopt;
    return at && glm::distance(*at, at_px) <= theme.px(reach_px);
}

void SunHandle::grab(glm::vec2 at_px)
{
    auto at = sun_ ? eye_.project(ball(), pane_size_px_) : std::nullopt;
    if (!at) return;
    glm::vec3 to_eye = eye_.orthographic ? eye_.backward() : eye_.position() - ball();
    grip_ = Grip{at_px, *at, glm::dot(ball() - eye_.pivot, to_eye) < 0, {}};
}

// Where the ray through a pixel meets the ball's sphere, on the side that was held; beside it, the nearest of its rim.
SunHandle::Angles SunHandle::angles_at(glm::vec2 at_px) const
{
    ViewCamera::Ray ray = eye_.ray(at_px, pane_size_px_);
    glm::vec3 way = eye_.pivot - ray.origin;
    float radius = metres(), middle = glm::dot(way, ray.direction);
    float inside = radius * radius - glm::dot(way, way) + middle * middle;  // half the chord, squared
    float along = middle + (grip_->far_side ? 1.0f : -1.0f) * std::sqrt(std::max(inside, 0.0f));
    glm::vec3 direction = glm::normalize(ray.origin + along * ray.direction - eye_.pivot);
    float azimuth = glm::degrees(std::atan2(direction.x, direction.z));
    return {glm::degrees(std::asin(std::clamp(direction.y, -1.0f, 1.0f))), nearest_turn(azimuth, angles_.azimuth_deg)};
}

void SunHandle::drag(FrameContext& frame, const TranslateGizmo::Hand& hand)
{
    if (!grip_) return;
    grip_->held_px += (hand.fine ? fine_share : 1.0f) * (hand.at_px - grip_->last_px);
    if (hand.at_px == grip_->last_px && !grip_->before) return;
    grip_->last_px = hand.at_px;
    Angles turned = angles_at(grip_->held_px);
    if (hand.snap) turned = {snapped(turned.elevation_deg), snapped(turned.azimuth_deg)};
    if (turned == angles_) return;
    if (!grip_->before) grip_->before = frame.draft.document;
    graph::Document& document = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    graph::Refusal refused =
        graph::set_parameter(document, library, sun_, known_types::sun_elevation, turned.elevation_deg);
    if (!refused) refused = graph::set_parameter(document, library, sun_, known_types::sun_azimuth, turned.azimuth_deg);
    if (frame.draft.done(step_name(frame.draft, sun_), refused)) angles_ = turned;
}

void SunHandle::cancel(FrameContext& frame)
{
    if (grip_ && grip_->before) {
        frame.draft.step = step_name(frame.draft, sun_);
        frame.draft.document = std::move(*grip_->before);
    }
    let_go();
}

void SunHandle::draw(ImDrawList& list, glm::vec2 pane_low, bool hot, FrameContext& frame) const
{
    auto from = sun_ ? eye_.project(eye_.pivot, pane_size_px_) : std::nullopt;
    auto to = sun_ ? eye_.project(ball(), pane_size_px_) : std::nullopt;
    if (!from || !to) return;
    const Theme& theme = frame.theme;
    glm::vec2 start = pane_low + *from, end = pane_low + *to, half(theme.px(ball_px));
    ImU32 ink = hot || grip_ ? colour::hot : colour::text, shade = colour::with_alpha(colour::window, 0.45f);
    list.AddLine(im(start), im(end), shade, theme.px(5));
    list.AddLine(im(start), im(end), ink, theme.px(2));
    list.AddCircleFilled(im(start), theme.px(3.5f), ink, 16);
    list.AddCircleFilled(im(end), theme.px(ball_px + 2), shade, 32);
    list.AddCircleFilled(im(end), theme.px(ball_px), ink, 32);
    ImFont& font = *theme.fonts.text;
    ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, icon::sun);
    list.AddText(&font, font.FontSize, im(glm::round(end - 0.5f * glm::vec2(size.x, size.y))), colour::window,
                 icon::sun);
    frame.rects.mark("viewport/gizmo/sun", {end - half, end + half});
}

}  // namespace fieldwright::ui
