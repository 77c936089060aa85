// The canvas on the screen: screen = the pane's corner + pan + scale * canvas. Nothing is ever transformed but points.
#pragma once

#include "ui/node_geometry.h"
#include "ui/view_state.h"

#include <optional>
#include <vector>

namespace fieldwright::ui {

inline constexpr float zoom_minimum = 0.1f, zoom_maximum = 4, zoom_per_notch = 1.2f;

struct CanvasSpace {
    glm::vec2 corner_px{0, 0}, size_px{1, 1};  // of the pane
    glm::vec2 pan_px{0, 0};
    float scale = 1;  // screen px per canvas px: the zoom times the display's scale

    glm::vec2 screen(glm::vec2 canvas) const { return corner_px + pan_px + scale * canvas; }
    Box screen(const Box& box) const { return {screen(box.low), screen(box.high)}; }
    glm::vec2 canvas(glm::vec2 screen_px) const { return (screen_px - corner_px - pan_px) / scale; }
    Box pane_px() const { return {corner_px, corner_px + size_px}; }
    Box visible() const { return {canvas(corner_px), canvas(corner_px + size_px)}; }  // canvas px
};

// Keeps the point under `at_px` (from the pane's corner) where it is.
void zoom_about(CanvasView& view, glm::vec2 at_px, float notches);
// A view that shows a box whole, never larger than zoom 1.
CanvasView view_of(const Box& box, glm::vec2 pane_px, float display_scale);

// What the view depends on that a graph is opened with.
struct Opening {
    Box graph, end;  // around all nodes, and the one they lead to
    std::vector<Box> nodes;
    glm::vec2 corner_px{0, 0};  // of the pane, lower right: other things lie there
};
// Whole while every word can be read then, else the part that leads to the end.
CanvasView opening_view(const Opening& opening, glm::vec2 pane_px, float display_scale);

// The way from one view to another, 130 ms long.
class CanvasGlide {
public:
    void start(const CanvasView& from, const CanvasView& to);
    void stop() { time_s_ = -1; }
    bool gliding() const { return time_s_ >= 0; }
    void advance(CanvasView& view, float seconds, bool at_once);

private:
    CanvasView from_, to_;
    float time_s_ = -1;  // since the start; negative = still
};

}  // namespace fieldwright::ui
