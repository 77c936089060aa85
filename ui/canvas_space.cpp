// Zooming about a point, framing, and gliding between views.
#include "ui/canvas_space.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float glide_s = 0.13f, frame_margin = 40, opening_zoom = 0.9f;

}  // namespace

void zoom_about(CanvasView& view, glm::vec2 at_px, float notches)
{
    float zoom = std::clamp(view.zoom * std::pow(zoom_per_notch, notches), zoom_minimum, zoom_maximum);
    view.pan_px = at_px - (at_px - view.pan_px) * (zoom / view.zoom);
    view.zoom = zoom;
}

CanvasView view_of(const Box& box, glm::vec2 pane_px, float display_scale)
{
    glm::vec2 room = glm::max(pane_px - 2 * frame_margin * display_scale, glm::vec2(1));
    glm::vec2 size = glm::max(box.size(), glm::vec2(1));
    float scale = std::min(room.x / size.x, room.y / size.y);
    CanvasView view;
    view.zoom = std::clamp(scale / display_scale, zoom_minimum, 1.0f);
    view.pan_px = 0.5f * pane_px - view.zoom * display_scale * box.centre();
    return view;
}

CanvasView opening_view(const Opening& opening, glm::vec2 pane_px, float display_scale)
{
    CanvasView view = view_of(opening.graph, pane_px, display_scale);
    if (view.zoom >= opening_zoom) return view;
    view.zoom = opening_zoom;
    float scale = opening_zoom * display_scale, margin = frame_margin * display_scale;
    glm::vec2 half = (0.5f * pane_px - margin) / scale;
    glm::vec2 low = opening.graph.low + half, high = opening.graph.high - half, middle = opening.graph.centre();
    if (low.x < high.x) middle.x = high.x;
    if (low.y < high.y) middle.y = std::clamp(opening.end.centre().y, low.y, high.y);
    if (glm::vec2 room = opening.corner_px / scale; room.y > 0) {
        float lowest = middle.y;
        for (const Box& node : opening.nodes)
            if (node.high.x > opening.graph.high.x - room.x) lowest = std::max(lowest, node.high.y);
        // What stands last comes above the corner, unless its end would leave at the top.
        middle.y = std::max(middle.y, std::min(lowest - half.y + room.y, opening.end.low.y + half.y));
    }
    view.pan_px = 0.5f * pane_px - scale * middle;
    return view;
}

void CanvasGlide::start(const CanvasView& from, const CanvasView& to)
{
    from_ = from;
    to_ = to;
    time_s_ = 0;
}

void CanvasGlide::advance(CanvasView& view, float seconds, bool at_once)
{
    if (!gliding()) return;
    time_s_ += seconds;
    float t = at_once ? 1.0f : std::min(time_s_ / glide_s, 1.0f);
    float eased = 1 - (1 - t) * (1 - t) * (1 - t);
    view.zoom = from_.zoom * std::pow(to_.zoom / from_.zoom, eased);
    view.pan_px = glm::mix(from_.pan_px, to_.pan_px, eased);
    if (t < 1) return;
    view = to_;
    stop();
}

}  // namespace fieldwright::ui
