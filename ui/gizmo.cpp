// Finding where the translate gizmo stands, dragging its handles, drawing them.
#include "ui/gizmo.h"

#include "graph/known_types.h"
#include "graph/neighbours.h"
#include "graph/scene_parts.h"
#include "graph/words.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fieldwright::ui {
namespace {

using Handle = TranslateGizmo::Handle;
namespace known_types = graph::known_types;

constexpr float arrow_px = 90, shaft_starts_px = 14, head_px = 13, centre_px = 7;  // design px
constexpr float reach_px = 9;                                                      // of the mouse
constexpr float shortest_px = 22;  // an arrow that points at the eye is left out
constexpr float snap_m = 0.1f, farthest_m = 1000, fine_share = 0.1f;
constexpr Handle arrows[] = {Handle::x, Handle::y, Handle::z};
constexpr const char *letters[] = {"X", "Y", "Z"}, *marks[] = {"x", "y", "z"};

int axis_of(Handle handle) { return static_cast<int>(handle) - static_cast<int>(Handle::x); }

glm::vec3 direction(Handle handle)
{
    glm::vec3 unit(0);
    unit[axis_of(handle)] = 1;
    return unit;
}

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b)
{
    glm::vec2 way = b - a;
    float share = std::clamp(glm::dot(p - a, way) / std::max(glm::dot(way, way), 1e-6f), 0.0f, 1.0f);
    return glm::distance(p, a + share * way);
}

glm::vec3 snapped(glm::vec3 way) { return snap_m * glm::round(way / snap_m); }

std::optional<glm::vec3> point_of(const graph::Document& document, graph::NodeId id, std::string_view parameter)
{
    const graph::Node* node = document.root.find(id);
    const graph::Value* value = node ? node->parameter(parameter) : nullptr;
    const auto* offset = value ? std::get_if<glm::vec3>(value) : nullptr;
    return offset ? std::optional(*offset) : std::nullopt;
}

std::string step_name(const Draft& draft, graph::NodeId id)
{
    const graph::Node* node = draft.document.root.find(id);
    return "Move " + (node ? graph::title_inside(*node, draft.library) : std::string("node"));
}

ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }

void draw_arrow(ImDrawList& list, glm::vec2 from, glm::vec2 tip, int axis, bool hot, const Theme& theme)
{
    ImU32 ink = hot ? colour::hot : colour::axes[axis];
    glm::vec2 way = glm::normalize(tip - from), across(-way.y, way.x);
    glm::vec2 neck = tip - theme.px(head_px) * way, start = from + theme.px(shaft_starts_px) * way;
    float width = theme.px(0.42f * head_px);
    ImU32 shade = colour::with_alpha(colour::window, 0.45f);  // an edge that shows on any picture
    if (glm::dot(neck - start, way) > 0) {
        list.AddLine(im(start), im(neck), shade, theme.px(5));
        list.AddLine(im(start), im(neck), ink, theme.px(2.5f));
    }
    list.AddTriangleFilled(im(tip), im(neck + width * across), im(neck - width * across), ink);
    ImFont& font = *theme.fonts.heading;
    ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, letters[axis]);
    glm::vec2 at = glm::round(tip + theme.px(11) * way - 0.5f * glm::vec2(size.x, size.y));
    list.AddText(&font, font.FontSize, im(at + glm::vec2(1)), colour::with_alpha(colour::window, 0.8f), letters[axis]);
    list.AddText(&font, font.FontSize, im(at), ink, letters[axis]);
}

}  // namespace

std::optional<float> along_axis(glm::vec3 origin, glm::vec3 axis, const ViewCamera::Ray& ray)
{
    glm::vec3 way = origin - ray.origin;
    float cosine = glm::dot(axis, ray.direction), across = 1 - cosine * cosine;
    if (across < 1e-4f) return std::nullopt;
    return (cosine * glm::dot(ray.direction, way) - glm::dot(axis, way)) / across;
}

std::optional<glm::vec3> on_plane(glm::vec3 origin, glm::vec3 normal, const ViewCamera::Ray& ray)
{
    float against = glm::dot(ray.direction, normal);
    if (std::abs(against) < 1e-4f) return std::nullopt;
    return ray.origin + glm::dot(origin - ray.origin, normal) / against * ray.direction;
}

void TranslateGizmo::place(FrameContext& frame, const ViewCamera& eye, glm::vec2 pane_size_px)
{
    eye_ = eye;
    pane_size_px_ = pane_size_px;
    length_px_ = frame.theme.px(arrow_px);
    graph::NodeId active = frame.view.selection.active();
    if (grip_ && stand_ && stand_->active == active) return;  // a hand moves it
    let_go();
    if (is_found(frame, active)) return;
    stand_ = find(frame, active);
    found_in_ = frame.readings.program;
    found_for_ = active;
    found_at_s_ = frame.readings.time_s;
    found_through_camera_ = frame.view.through_camera;
}

void TranslateGizmo::hide()
{
    stand_.reset();
    found_in_.reset();
    let_go();
}

bool TranslateGizmo::is_found(const FrameContext& frame, graph::NodeId active) const
{
    return found_in_ && found_in_ == frame.readings.program && found_for_ == active &&
           found_at_s_ == frame.readings.time_s && found_through_camera_ == frame.view.through_camera;
}

std::optional<TranslateGizmo::Stand> TranslateGizmo::find(const FrameContext& frame, graph::NodeId active) const
{
    const graph::Node* node = frame.draft.document.root.find(active);
    const graph::NodeType* type = node ? frame.draft.library.type(node->type) : nullptr;
    if (!type || type->category == "output") return std::nullopt;
    if (std::optional<Stand> stand = stand_on_point(frame, *node, *type)) return stand;
    for (graph::NodeId id : graph::own_way(frame.draft.document, frame.draft.library, active))
        if (std::optional<Stand> stand = stand_at(frame, id)) {
            stand->active = active;
            return stand;
        }
    return std::nullopt;
}

// Of lamps where they are, of cameras what they look at; not of the camera that the picture is seen by.
std::optional<TranslateGizmo::Stand> TranslateGizmo::stand_on_point(const FrameContext& frame, const graph::Node& node,
                                                                    const graph::NodeType& type) const
{
    bool lamp = type.category == "light", camera = type.category == "camera";
    if ((!lamp && !camera) || node.muted || (camera && frame.view.through_camera)) return std::nullopt;
    std::string_view parameter = lamp ? known_types::light_position : known_types::camera_target;
    std::optional<glm::vec3> point = point_of(frame.draft.document, node.id, parameter);
    if (!point || node.input(parameter)) return std::nullopt;
    Stand stand{node.id, node.id, node.id, parameter, {}, *point};
    if (camera) stand.seen_from = point_of(frame.draft.document, node.id, known_types::camera_position);
    return stand;
}

std::optional<TranslateGizmo::Stand> TranslateGizmo::stand_at(const FrameContext& frame, graph::NodeId node) const
{
    const graph::Document& document = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    graph::NodeId translate = graph::nearest_translate(document, library, node), anchor = translate ? translate : node;
    std::optional<Placement> place = placement(document, library, anchor);
    if (!place) return std::nullopt;
    std::string_view parameter = known_types::translate_offset;
    glm::vec3 middle = point_of(document, translate, parameter).value_or(glm::vec3(0));
    auto box = frame.readings.bounds_of ? frame.readings.bounds_of(anchor) : std::nullopt;
    for (int axis = 0; box && axis < 3; ++axis)
        if (box->half_size[axis] < 0.5f * unbounded) middle[axis] = box->centre[axis];
    return Stand{{}, node, translate, parameter, *place, place->world_from_node(middle)};
}

float TranslateGizmo::metres() const
{
    return eye_.height_at(stand_->origin) * length_px_ / std::max(pane_size_px_.y, 1.0f);
}

std::optional<glm::vec2> TranslateGizmo::tip(Handle handle) const
{
    auto from = eye_.project(stand_->origin, pane_size_px_);
    auto to = eye_.project(stand_->origin + metres() * direction(handle), pane_size_px_);
    if (!from || !to || glm::distance(*from, *to) < shortest_px / arrow_px * length_px_) return std::nullopt;
    return to;
}

Handle TranslateGizmo::handle_at(glm::vec2 at_px, const Theme& theme) const
{
    auto centre = stand_ ? eye_.project(stand_->origin, pane_size_px_) : std::nullopt;
    if (!centre) return Handle::none;
    if (glm::distance(at_px, *centre) <= theme.px(centre_px + 3)) return Handle::centre;
    Handle nearest = Handle::none;
    float least = theme.px(reach_px);
    for (Handle handle : arrows) {
        auto end = tip(handle);
        float away = end ? distance_to_segment(at_px, *centre, *end) : least;
        if (away < least) least = away, nearest = handle;
    }
    return nearest;
}

std::optional<glm::vec3> TranslateGizmo::held(Handle handle, glm::vec3 origin, glm::vec2 at_px) const
{
    ViewCamera::Ray ray = eye_.ray(at_px, pane_size_px_);
    if (handle == Handle::centre) return on_plane(origin, eye_.backward(), ray);
    auto along = along_axis(origin, direction(handle), ray);
    return along ? std::optional(origin + *along * direction(handle)) : std::nullopt;
}

void TranslateGizmo::grab(Handle handle, glm::vec2 at_px)
{
    auto start = stand_ && handle != Handle::none ? held(handle, stand_->origin, at_px) : std::nullopt;
    if (start) grip_ = Grip{handle, stand_->origin, *start, at_px, at_px, {}, {}};
}

void TranslateGizmo::drag(FrameContext& frame, const Hand& hand)
{
    if (!grip_) return;
    grip_->held_px += (hand.fine ? fine_share : 1.0f) * (hand.at_px - grip_->last_px);
    grip_->last_px = hand.at_px;
    auto point = held(grip_->handle, grip_->origin, grip_->held_px);
    if (point) move(frame, hand.snap ? snapped(*point - grip_->start) : *point - grip_->start);
}

void TranslateGizmo::move(FrameContext& frame, glm::vec3 way)
{
    if (way == glm::vec3(0) && !grip_->before) return;
    if (!give_translate(frame)) return;
    graph::Document& document = frame.draft.document;
    glm::vec3 offset = grip_->offset_before + glm::inverse(stand_->place.linear) * way;
    offset = glm::clamp(offset, glm::vec3(-farthest_m), glm::vec3(farthest_m));
    stand_->origin = grip_->origin + stand_->place.linear * (offset - grip_->offset_before);
    if (offset == point_of(document, stand_->mover, stand_->parameter)) return;
    frame.draft.done(step_name(frame.draft, stand_->active),
                     graph::set_parameter(document, frame.draft.library, stand_->mover, stand_->parameter, offset));
}

// The translate to be moved: inserted by the first move. False when it cannot be.
bool TranslateGizmo::give_translate(FrameContext& frame)
{
    graph::Document& document = frame.draft.document;
    if (!grip_->before) grip_->before = document;
    if (!stand_->mover) {
        graph::Placed placed = graph::insert_translate(document, frame.draft.library, stand_->node);
        if (!frame.draft.done(step_name(frame.draft, stand_->active), placed.refusal)) return let_go(), false;
        stand_->mover = placed.node;
    } else if (auto offset = point_of(*grip_->before, stand_->mover, stand_->parameter)) {
        grip_->offset_before = *offset;
    }
    if (point_of(document, stand_->mover, stand_->parameter)) return true;
    let_go();  // it was deleted under the hand
    return false;
}

void TranslateGizmo::cancel(FrameContext& frame)
{
    if (!grip_) return;
    if (grip_->before) {
        frame.draft.step = step_name(frame.draft, stand_->active);
        frame.draft.document = std::move(*grip_->before);
    }
    let_go();
}

void TranslateGizmo::let_go() { grip_.reset(); }

void TranslateGizmo::draw(ImDrawList& list, glm::vec2 pane_low, Handle hot, FrameContext& frame) const
{
    auto centre = stand_ ? eye_.project(stand_->origin, pane_size_px_) : std::nullopt;
    if (!centre) return;
    const Theme& theme = frame.theme;
    glm::vec2 from = pane_low + *centre, half(theme.px(reach_px));
    if (grip_ && grip_->handle != Handle::centre)
        if (auto end = tip(grip_->handle)) {  // the line it moves on
            glm::vec2 way = 4000.0f * glm::normalize(*end - *centre);
            list.AddLine(im(from - way), im(from + way), colour::with_alpha(colour::hot, 0.35f), theme.px(1));
        }
    auto eye = stand_->seen_from ? eye_.project(*stand_->seen_from, pane_size_px_) : std::nullopt;
    if (eye) list.AddLine(im(pane_low + *eye), im(from), colour::with_alpha(colour::text, 0.6f), theme.px(1));
    for (Handle handle : arrows) {
        auto end = tip(handle);
        if (!end) continue;
        draw_arrow(list, from, pane_low + *end, axis_of(handle), handle == hot, theme);
        frame.rects.mark(std::string("viewport/gizmo/") + marks[axis_of(handle)],
                         {pane_low + *end - half, pane_low + *end + half});
    }
    ImU32 ink = hot == Handle::centre ? colour::hot : colour::text;
    list.AddCircleFilled(im(from), theme.px(centre_px + 1.5f), colour::with_alpha(colour::window, 0.45f), 32);
    list.AddCircleFilled(im(from), theme.px(centre_px), ink, 32);
    frame.rects.mark("viewport/gizmo/centre", {from - half, from + half});
}

}  // namespace fieldwright::ui
