// Canvas: the node canvas: nodes, wires, and the hands on them. Laid out in screen space, so that text stays crisp at
// every zoom; a gesture changes the document once, when it ends.
//
// Hands: the wheel zooms about the cursor; dragging with the middle or the right button pans. Drag from a pin to wire,
// off a wired input to detach, into empty space to add what fits. Drag a node onto a wire to insert it (Alt: not).
// Ctrl+drag from an output moves all of its wires, Alt+click on a pin breaks them, Ctrl+right drag cuts them.
// Ctrl+Alt+drag draws a lasso around nodes. A right click opens a menu.
#pragma once

#include "ui/add_menu.h"
#include "ui/canvas_hands.h"
#include "ui/canvas_minimap.h"
#include "ui/canvas_painter.h"
#include "ui/frame_context.h"

namespace fieldwright::ui {

class Canvas {
public:
    // Fills the current ImGui child window.
    void draw(FrameContext& frame);
    // A gesture is under way.
    bool busy() const { return !hands_.resting(); }
    template <typename Kind>
    const Kind* doing() const  // the gesture, when it is of a kind
    {
        return hands_.doing<Kind>();
    }
    // The mouse is over the canvas: its shortcuts apply.
    bool hovered() const { return hovered_; }
    // The mouse on the canvas, or the middle of the pane when the mouse is elsewhere: where a paste goes.
    glm::vec2 cursor_on_canvas() const;

    // What commands ask for; done when the canvas is next drawn.
    void open_add_menu() { wanted_.add_menu = true; }  // at the mouse, or in the middle of the pane
    void frame_all() { wanted_.frame_all = true; }
    void frame_opening() { wanted_.frame_opening = true; }    // of a graph never seen: titles stay large enough
    void frame_selected() { wanted_.frame_selected = true; }  // all when nothing is selected
    void show(graph::NodeId node) { wanted_.shown = node; }   // brings a node into view, keeping the zoom
    void begin_rename(graph::NodeId node);
    void select_all(FrameContext& frame);
    // The canvas shows the inside of a group node, or what is around the group that is open, from the next frame on.
    void enter(FrameContext& frame, graph::NodeId group_node);
    void leave(FrameContext& frame, std::size_t groups_left_open);

    // Adds a node as the add menu does: a shape is united with what is shown, an operator goes after the active node,
    // anything else is placed at the cursor. It becomes the selection. NodeId{} when refused.
    graph::NodeId add(FrameContext& frame, std::string_view type);
    // The same with a new own type, which begins as a template of graph/custom_nodes.h.
    graph::NodeId add_custom(FrameContext& frame, std::string_view template_name);

private:
    struct Wanted {
        bool add_menu = false, frame_all = false, frame_opening = false, frame_selected = false, opens_group = false;
        graph::NodeId shown;
    };
    struct Rename {
        graph::NodeId node;
        std::string text;
        bool opening = false;
    };

    void place(const FrameContext& frame);
    bool surface();  // true when the mouse can press on the canvas itself
    void zoom(FrameContext& frame);
    void follow_hand(FrameContext& frame);
    void serve(FrameContext& frame, const CanvasLayout& layout);
    void grant(FrameContext& frame, const CanvasWish& wish);
    void open_view(FrameContext& frame, const CanvasLayout& layout);
    void bring_into_view(const FrameContext& frame, const Box& box);
    void minimap(FrameContext& frame, const CanvasLayout& layout, bool over);
    graph::NodeId add_custom_at(FrameContext& frame, std::string_view template_name, glm::vec2 position);
    graph::NodeId add_and_show(FrameContext& frame, const graph::NodeType& type, const AddPlace& place);

    void paint(FrameContext& frame, const CanvasLayout& layout, const Hover& hover);
    void paint_wires(CanvasPainter& painter, const FrameContext& frame, const CanvasLayout& layout, const Hover& hover);
    void paint_nodes(CanvasPainter& painter, const FrameContext& frame, const CanvasLayout& layout, const Hover& hover);
    void paint_pins(CanvasPainter& painter, const CanvasNode& node, const Hover& hover);
    void paint_moving_wires(CanvasPainter& painter, const CanvasLayout& layout, const MovingWires& moved);
    void paint_gesture(CanvasPainter& painter, const CanvasLayout& layout);
    void tooltip(const FrameContext& frame, const CanvasLayout& layout, const Hover& hover);
    void mark(FrameContext& frame, const CanvasLayout& layout) const;
    void rename_field(FrameContext& frame, const CanvasLayout& layout);
    void empty_state(FrameContext& frame);
    void node_menu(FrameContext& frame);
    void wire_menu(FrameContext& frame);
    void group_entries(FrameContext& frame, const graph::Node& node);
    void breadcrumbs(FrameContext& frame);

    CanvasHands hands_;
    CanvasGlide glide_;
    AddMenu add_menu_;
    Minimap minimap_;
    CanvasSpace space_;
    Wanted wanted_;
    Rename rename_;
    Hover menu_for_;    // what the open context menu is about
    Hover last_hover_;  // and since when: tooltips wait
    float hover_s_ = 0;
    bool hovered_ = false;
};

}  // namespace fieldwright::ui
