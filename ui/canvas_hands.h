// The hands on the canvas: one gesture at a time, which changes the document once, when it ends; Escape undoes it.
#pragma once

#include "ui/add_menu.h"
#include "ui/canvas_layout.h"
#include "ui/canvas_space.h"
#include "ui/frame_context.h"
#include "ui/wire_targets.h"

#include <variant>

namespace fieldwright::ui {

struct InputName {  // of a node
    graph::NodeId node;
    std::string socket;
    bool operator==(const InputName&) const = default;
};

// What the hand is doing; places are in canvas px.
struct Resting {};
struct Panning {
    int button;
    glm::vec2 from_px;  // of the screen
    Hover pressed;
    bool moved = false;
};
struct Pressing {  // a node, which may become a drag
    glm::vec2 from_px;
    graph::NodeId node;
    bool chooses_it = false;  // alone, when nothing was dragged
};
struct MovingNodes {
    glm::vec2 from;
    glm::vec2 by{0, 0};
    std::optional<InputName> over;  // the wire that the node lies on
    bool inserts = false;           // into it
};
struct BoxSelecting {
    glm::vec2 from, to;
    std::vector<graph::NodeId> before;
    bool moved = false;
};
struct LassoSelecting {
    std::vector<glm::vec2> points;
    std::vector<graph::NodeId> before;
    bool moved = false;
};
struct Wiring {
    WireTargets targets;
    std::optional<InputName> detached;  // the wire that was taken off its input
    glm::vec2 to;
    std::optional<InputName> target;  // under the hand; an output has no socket
    graph::NodeId unfit;              // the node under the hand, when no pin of it will do
    std::string reason;               // why not
};
// All wires of an output, on their way to another one.
struct MovingWires {
    graph::NodeId from;
    std::vector<InputName> inputs;
    glm::vec2 to;
    graph::NodeId target;  // under the hand
    std::string reason;    // why not
};
struct Cutting {
    std::vector<glm::vec2> points;
};
struct Recentring {};  // by the minimap

using Gesture = std::variant<Resting, Panning, Pressing, MovingNodes, BoxSelecting, LassoSelecting, Wiring, MovingWires,
                             Cutting, Recentring>;

// What the hand asks of the canvas.
struct CanvasWish {
    std::optional<AddPlace> add;
    std::optional<Hover> menu;  // a right click on a node or wire
    graph::NodeId rename;
    graph::NodeId enter;  // a group
};

// What the hand sees in this frame.
struct CanvasSight {
    const CanvasSpace& space;
    const CanvasLayout& layout;
    Hover hover;
    glm::vec2 mouse_px;
    bool over = false;  // the mouse can press here
    glm::vec2 mouse() const { return space.canvas(mouse_px); }
};

class CanvasHands {
public:
    CanvasWish update(FrameContext& frame, const CanvasSight& sight);
    const Gesture& gesture() const { return gesture_; }
    bool resting() const { return std::holds_alternative<Resting>(gesture_); }
    void let_go() { gesture_ = Resting{}; }
    // The minimap was pressed: it is served by the canvas until the button comes up.
    void recentre() { gesture_ = Recentring{}; }
    // How far the selected nodes are being moved.
    glm::vec2 drag() const;
    template <typename Kind>
    const Kind* doing() const
    {
        return std::get_if<Kind>(&gesture_);
    }

private:
    void press(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish);
    void press_left(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish);
    void press_node(FrameContext& frame, const CanvasSight& sight);
    void press_pin(FrameContext& frame, const CanvasSight& sight);
    void pick_up_wire(FrameContext& frame, const CanvasSight& sight);

    void go_on(FrameContext&, const CanvasSight&, Resting&) {}
    void go_on(FrameContext& frame, const CanvasSight& sight, Panning& pan);
    void go_on(FrameContext& frame, const CanvasSight& sight, Pressing& press);
    void go_on(FrameContext& frame, const CanvasSight& sight, MovingNodes& move);
    void go_on(FrameContext& frame, const CanvasSight& sight, BoxSelecting& box);
    void go_on(FrameContext& frame, const CanvasSight& sight, LassoSelecting& lasso);
    void go_on(FrameContext& frame, const CanvasSight& sight, Wiring& wiring);
    void go_on(FrameContext& frame, const CanvasSight& sight, MovingWires& wires);
    void go_on(FrameContext& frame, const CanvasSight& sight, Cutting& cut);
    void go_on(FrameContext&, const CanvasSight&, Recentring&) {}

    void end(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish, Gesture& gesture);
    void end_pan(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish, const Panning& pan);
    void end_move(FrameContext& frame, const MovingNodes& move);
    void end_wiring(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish, const Wiring& wiring);
    void end_moving_wires(FrameContext& frame, const CanvasSight& sight, const MovingWires& wires);
    void end_cut(FrameContext& frame, const CanvasSight& sight, const Cutting& cut);

    Gesture gesture_;
};

}  // namespace fieldwright::ui
