// Draws the node canvas with the lists of Dear ImGui, in screen px; what is out of sight is left out.
#pragma once

#include "ui/canvas_layout.h"
#include "ui/canvas_space.h"
#include "ui/theme.h"

#include "graph/problem.h"

#include <map>

namespace fieldwright::ui {

// How much of a node is drawn: less the smaller it is.
enum class Detail { boxes, titles, full };
Detail detail_at(float zoom);  // titles below 0.5, boxes below 0.25

// What a node looks like apart from what it is.
struct NodeLook {
    bool selected = false, hovered = false;
    const graph::Problem* problem = nullptr;
    bool renamed = false;  // its title is being typed
};

enum class WireLook { plain, hovered, selected, faint };
enum class PinLook { plain, hovered, glowing, dim };

// Parts of a node that have a tooltip of their own, canvas px.
Box problem_badge(const Box& node);
Box quality_badge(const Box& node, bool with_problem);

class CanvasPainter {
public:
    CanvasPainter(ImDrawList& list, const Theme& theme, const CanvasSpace& space, float zoom);

    Detail detail() const { return detail_; }
    bool visible(const Box& box) const { return box.touches(seen_); }

    void grid();
    void wire(const WireCurve& curve, graph::SocketKind kind, WireLook look);
    void node(const CanvasNode& node, const NodeLook& look);
    // `alpha`: below 1 for nodes that a wire in the hand cannot go to.
    void pin(glm::vec2 at, graph::SocketKind kind, bool wired, PinLook look);
    void caption(const Box& node, std::string_view words);  // below a node
    void cost(const Box& node, std::string_view words);     // above its right end
    void selection_box(const Box& box);
    void lasso(const std::vector<glm::vec2>& points);
    void cut_stroke(const std::vector<glm::vec2>& points);

    // Font size in screen px; clipped with an ellipsis to `width_px`. True when nothing had to be left out.
    bool text(glm::vec2 at_px, float size_px, ImU32 colour, std::string_view text, float width_px,
              bool heading = false);
    float text_width(float size_px, std::string_view text, bool heading = false) const;

private:
    float label_px() const;
    float px(float canvas) const { return canvas * space_.scale; }
    void stroke_in_sight(const WireCurve& curve, ImU32 colour, float width_px);
    void shadow(const Box& box_px, float rounding);
    void outline(const Box& box_px, const NodeLook& look, float rounding);
    void plain_box(const CanvasNode& node, const NodeLook& look, const Box& box_px);
    void title_box(const CanvasNode& node, const NodeLook& look, const Box& box_px);
    void full_box(const CanvasNode& node, const NodeLook& look, const Box& box_px);
    void header(const CanvasNode& node, const NodeLook& look, const Box& box_px);
    void row(const CanvasNode& node, std::size_t row);
    void row_value(const CanvasNode& node, std::size_t row, float left_px, float middle_px);
    void bypass_line(const CanvasNode& node, const Box& box_px);

    ImDrawList& list_;
    const Theme& theme_;
    const CanvasSpace& space_;
    Detail detail_;
    Box seen_;
};

}  // namespace fieldwright::ui
