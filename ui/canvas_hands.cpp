// Gestures from press to release.
#include "ui/canvas_hands.h"

#include "graph/groups.h"

#include "ui/canvas_edits.h"
#include "ui/keys.h"

#include <imgui.h>

#include <algorithm>

namespace fieldwright::ui {

using graph::NodeId;

namespace {

constexpr float drag_threshold_px = 3;  // design px

int button_of(const Gesture& gesture)
{
    if (const Panning* pan = std::get_if<Panning>(&gesture)) return pan->button;
    return std::holds_alternative<Cutting>(gesture) ? ImGuiMouseButton_Right : ImGuiMouseButton_Left;
}

bool farther_than_threshold(const FrameContext& frame, glm::vec2 from_px, glm::vec2 to_px)
{
    return glm::length(to_px - from_px) >= frame.theme.px(drag_threshold_px);
}

// The pin of a node that the wire fits and that is nearest to the hand: a drop anywhere on a node will do.
std::optional<InputName> nearest_fit(const CanvasNode& node, const WireTargets& targets, glm::vec2 p)
{
    if (!targets.end().socket.empty())
        return targets.fits(node.node->id, "") ? std::optional(InputName{node.node->id, ""}) : std::nullopt;
    std::optional<InputName> nearest;
    float least = 1e9f;
    for (std::size_t row = 0; row < node.input_count(); ++row) {
        float distance = glm::length(node.input_pin(row) - p);
        if (distance >= least || !targets.fits(node.node->id, node.input_name(row))) continue;
        least = distance;
        nearest = InputName{node.node->id, std::string(node.input_name(row))};
    }
    return nearest;
}

bool is_own_end(const Hover& hover, const graph::LooseEnd& end)
{
    return hover.node == end.node &&
           (hover.kind == Hover::Kind::output ? end.socket.empty() : hover.socket == end.socket);
}

// Under a double click.
bool opens_group(const FrameContext& frame, const Hover& hover)
{
    const graph::Node* node = hover.is_node() ? frame.draft.document.root.find(hover.node) : nullptr;
    return node && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && graph::group_of(frame.draft.document, *node);
}

}  // namespace

glm::vec2 CanvasHands::drag() const
{
    const MovingNodes* move = std::get_if<MovingNodes>(&gesture_);
    return move ? move->by : glm::vec2(0);
}

CanvasWish CanvasHands::update(FrameContext& frame, const CanvasSight& sight)
{
    CanvasWish wish;
    if (resting()) {
        if (sight.over) press(frame, sight, wish);
        return wish;
    }
    if (ImGui::IsKeyPressed(key::escape, false) || !ImGui::IsMousePosValid()) {
        if (BoxSelecting* box = std::get_if<BoxSelecting>(&gesture_)) frame.view.selection.replace(box->before);
        if (LassoSelecting* lasso = std::get_if<LassoSelecting>(&gesture_)) frame.view.selection.replace(lasso->before);
        let_go();
        return wish;
    }
    std::visit([&](auto& now) { go_on(frame, sight, now); }, gesture_);
    if (!ImGui::IsMouseDown(button_of(gesture_))) {
        Gesture done = std::exchange(gesture_, Resting{});
        end(frame, sight, wish, done);
    }
    return wish;
}

void CanvasHands::press(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle))
        gesture_ = Panning{ImGuiMouseButton_Middle, sight.mouse_px, sight.hover};
    else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) && io.KeyCtrl) gesture_ = Cutting{{sight.mouse()}};
    else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        gesture_ = Panning{ImGuiMouseButton_Right, sight.mouse_px, sight.hover};
    else if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press_left(frame, sight, wish);
}

void CanvasHands::press_left(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && io.KeyAlt) gesture_ = LassoSelecting{{sight.mouse()}, frame.view.selection.nodes()};
    else if (opens_group(frame, sight.hover)) wish.enter = sight.hover.node;
    else if (sight.hover.kind == Hover::Kind::header && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        wish.rename = sight.hover.node;
    else if (sight.hover.is_pin() && io.KeyAlt) break_wires(frame, sight.hover);
    else if (sight.hover.is_pin()) press_pin(frame, sight);
    else if (sight.hover.is_node()) press_node(frame, sight);
    else gesture_ = BoxSelecting{sight.mouse(), sight.mouse(), frame.view.selection.nodes()};
}

void CanvasHands::press_node(FrameContext& frame, const CanvasSight& sight)
{
    const ImGuiIO& io = ImGui::GetIO();
    Selection& selection = frame.view.selection;
    NodeId node = sight.hover.node;
    bool was_selected = selection.contains(node);
    if (io.KeyCtrl) selection.toggle(node);
    else if (io.KeyShift) selection.add(node);
    else if (!was_selected) selection.only(node);
    if (selection.contains(node))
        gesture_ = Pressing{sight.mouse_px, node, was_selected && !io.KeyCtrl && !io.KeyShift};
}

// With Ctrl, all wires of an output; an input has one anyway.
void CanvasHands::press_pin(FrameContext& frame, const CanvasSight& sight)
{
    std::vector<InputName> inputs;
    if (ImGui::GetIO().KeyCtrl && sight.hover.kind == Hover::Kind::output)
        for (const CanvasWire& wire : sight.layout.wires())
            if (wire.source == sight.hover.node) inputs.push_back({wire.target, std::string(wire.socket)});
    if (inputs.empty()) pick_up_wire(frame, sight);
    else gesture_ = MovingWires{sight.hover.node, std::move(inputs), sight.mouse(), {}, {}};
}

void CanvasHands::pick_up_wire(FrameContext& frame, const CanvasSight& sight)
{
    graph::LooseEnd end{sight.hover.node, sight.hover.socket};
    std::optional<InputName> detached;
    graph::Document rest = frame.draft.document;
    const graph::Node* node = rest.root.find(sight.hover.node);
    NodeId source = node && !end.socket.empty() ? node->input(end.socket) : NodeId{};
    if (source && !graph::disconnect(rest, end.node, end.socket)) {
        detached = InputName{end.node, end.socket};
        end = {source, ""};
    }
    gesture_ = Wiring{WireTargets(std::move(rest), frame.draft.library, end), detached, sight.mouse(), {}, {}};
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, Panning& pan)
{
    if (!pan.moved && !farther_than_threshold(frame, pan.from_px, sight.mouse_px)) return;
    glm::vec2 moved =
        pan.moved ? glm::vec2(ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y) : sight.mouse_px - pan.from_px;
    frame.view.canvas.pan_px += moved;
    pan.moved = true;
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, Pressing& press)
{
    if (!farther_than_threshold(frame, press.from_px, sight.mouse_px)) return;
    MovingNodes move{sight.space.canvas(press.from_px), {}, {}};
    go_on(frame, sight, move);
    gesture_ = move;
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, MovingNodes& move)
{
    move.by = sight.mouse() - move.from;
    const Selection& selection = frame.view.selection;
    const CanvasWire* wire = nullptr;
    if (selection.nodes().size() == 1 && !ImGui::GetIO().KeyAlt) wire = sight.layout.wire_through(selection.active());
    std::optional<InputName> over;
    if (wire) over = InputName{wire->target, std::string(wire->socket)};
    if (over == move.over) return;
    move.over = over;
    move.inserts = over && can_insert(frame.draft, selection.active(), over->node, over->socket);
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, BoxSelecting& box)
{
    box.to = sight.mouse();
    box.moved = box.moved || farther_than_threshold(frame, sight.space.screen(box.from), sight.mouse_px);
    if (!box.moved) return;
    const ImGuiIO& io = ImGui::GetIO();
    Selection& selection = frame.view.selection;
    selection.clear();
    if (io.KeyShift || io.KeyCtrl) selection.replace(box.before);
    for (NodeId id : sight.layout.inside(box_between(box.from, box.to)))
        if (io.KeyCtrl) selection.toggle(id);
        else selection.add(id);
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, Wiring& wiring)
{
    wiring.to = sight.mouse();
    std::optional<InputName> target;
    NodeId unfit;
    bool fits = false;
    if (sight.hover.is_pin() && !is_own_end(sight.hover, wiring.targets.end())) {
        target = InputName{sight.hover.node, sight.hover.socket};
        fits = wiring.targets.fits(target->node, target->socket);
    } else if (const CanvasNode* node = sight.hover.is_node() ? sight.layout.find(sight.hover.node) : nullptr) {
        target = nearest_fit(*node, wiring.targets, sight.mouse());
        fits = target.has_value();
        if (!fits && node->node->id != wiring.targets.end().node) unfit = node->node->id;
    }
    if (target == wiring.target && unfit == wiring.unfit) return;
    wiring.target = target;
    wiring.unfit = unfit;
    wiring.reason.clear();
    if (unfit) wiring.reason = wiring.targets.reason(frame.draft.library, unfit);
    if (target && !fits) wiring.reason = wiring.targets.reason(frame.draft.library, target->node, target->socket);
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, LassoSelecting& lasso)
{
    if (!farther_than_threshold(frame, sight.space.screen(lasso.points.back()), sight.mouse_px)) return;
    lasso.points.push_back(sight.mouse());
    lasso.moved = true;
    Selection& selection = frame.view.selection;
    selection.clear();
    if (ImGui::GetIO().KeyShift) selection.replace(lasso.before);
    for (NodeId id : sight.layout.inside(lasso.points)) selection.add(id);
}

void CanvasHands::go_on(FrameContext& frame, const CanvasSight& sight, MovingWires& wires)
{
    wires.to = sight.mouse();
    const CanvasNode* node =
        sight.hover.is_node() || sight.hover.is_pin() ? sight.layout.find(sight.hover.node) : nullptr;
    NodeId target = node && has_output(node->type) && sight.hover.node != wires.from ? sight.hover.node : NodeId{};
    if (target == wires.target) return;
    wires.target = target;
    wires.reason.clear();
    if (!target) return;
    graph::Document trial = frame.draft.document;
    if (graph::Refusal refused = move_wires(trial, frame.draft.library, wires)) wires.reason = *refused;
}

void CanvasHands::go_on(FrameContext&, const CanvasSight& sight, Cutting& cut)
{
    if (cut.points.back() != sight.mouse()) cut.points.push_back(sight.mouse());
}

void CanvasHands::end(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish, Gesture& gesture)
{
    if (const Panning* pan = std::get_if<Panning>(&gesture)) end_pan(frame, sight, wish, *pan);
    else if (const Pressing* press = std::get_if<Pressing>(&gesture)) {
        if (press->chooses_it) frame.view.selection.only(press->node);
    } else if (const MovingNodes* move = std::get_if<MovingNodes>(&gesture)) end_move(frame, *move);
    else if (const BoxSelecting* box = std::get_if<BoxSelecting>(&gesture)) {
        if (!box->moved && !ImGui::GetIO().KeyShift && !ImGui::GetIO().KeyCtrl) frame.view.selection.clear();
    } else if (const LassoSelecting* lasso = std::get_if<LassoSelecting>(&gesture)) {
        if (!lasso->moved) frame.view.selection.clear();
    } else if (const Wiring* wiring = std::get_if<Wiring>(&gesture)) end_wiring(frame, sight, wish, *wiring);
    else if (const MovingWires* wires = std::get_if<MovingWires>(&gesture)) end_moving_wires(frame, sight, *wires);
    else if (const Cutting* cut = std::get_if<Cutting>(&gesture)) end_cut(frame, sight, *cut);
}

void CanvasHands::end_pan(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish, const Panning& pan)
{
    if (pan.moved || pan.button != ImGuiMouseButton_Right) return;
    if (pan.pressed.kind == Hover::Kind::nothing) {
        wish.add = AddPlace{.position = sight.mouse()};
        return;
    }
    wish.menu = pan.pressed;
    bool is_wire = pan.pressed.kind == Hover::Kind::wire;
    if (!is_wire && !frame.view.selection.contains(pan.pressed.node)) frame.view.selection.only(pan.pressed.node);
}

void CanvasHands::end_move(FrameContext& frame, const MovingNodes& move)
{
    if (move.inserts) move_onto_wire(frame, move.by, move.over->node, move.over->socket);
    else move_selection(frame, move.by);
}

void CanvasHands::end_wiring(FrameContext& frame, const CanvasSight& sight, CanvasWish& wish, const Wiring& wiring)
{
    if (wiring.detached && wiring.detached == wiring.target) return;  // put back
    if (!wiring.reason.empty()) {
        frame.draft.refusal = wiring.reason;
        return;
    }
    if (wiring.target) {
        graph::Document trial = frame.draft.document;
        graph::Refusal refused;
        if (wiring.detached) refused = graph::disconnect(trial, wiring.detached->node, wiring.detached->socket);
        if (!refused)
            refused = wiring.targets.connect(trial, frame.draft.library, wiring.target->node, wiring.target->socket);
        if (frame.draft.done("Connect", refused)) frame.draft.document = std::move(trial);
        return;
    }
    if (wiring.detached) {
        if (sight.hover.is_empty())
            frame.draft.done("Disconnect",
                             graph::disconnect(frame.draft.document, wiring.detached->node, wiring.detached->socket));
        return;
    }
    bool far = glm::length(sight.mouse() - loose_end_pin(sight.layout, wiring.targets.end())) > node_header;
    if (sight.hover.is_empty() && far) wish.add = AddPlace{.position = sight.mouse(), .end = wiring.targets.end()};
}

void CanvasHands::end_moving_wires(FrameContext& frame, const CanvasSight& sight, const MovingWires& wires)
{
    if (!wires.target && !sight.hover.is_empty()) return;  // put back
    graph::Document trial = frame.draft.document;
    graph::Refusal refused = move_wires(trial, frame.draft.library, wires);
    std::string step = (wires.target ? "Move " : "Disconnect ") + std::to_string(wires.inputs.size()) +
                       (wires.inputs.size() == 1 ? " wire" : " wires");
    if (frame.draft.done(step, refused)) frame.draft.document = std::move(trial);
}

void CanvasHands::end_cut(FrameContext& frame, const CanvasSight& sight, const Cutting& cut)
{
    std::vector<InputName> crossed;
    for (const CanvasWire& wire : sight.layout.wires())
        for (std::size_t i = 1; i < cut.points.size(); ++i)
            if (crosses(wire.curve, cut.points[i - 1], cut.points[i])) {
                crossed.push_back({wire.target, std::string(wire.socket)});
                break;
            }
    cut_wires(frame, crossed);
}

}  // namespace fieldwright::ui
