// What the canvas shows in a frame, with the looks that hovering, selection and gestures give it.
#include "ui/canvas.h"

#include "ui/canvas_edits.h"
#include "ui/node_words.h"
#include "ui/number_text.h"

#include "graph/groups.h"

#include <imgui.h>

namespace fieldwright::ui {

using graph::NodeId;

namespace {

constexpr float tooltip_delay_s = 0.45f, help_delay_s = 1, tooltip_width = 320;

// The worst of a node's problems.
std::map<NodeId, const graph::Problem*> problems_by_node(const std::vector<graph::Problem>& problems)
{
    std::map<NodeId, const graph::Problem*> found;
    for (const graph::Problem& problem : problems) {
        if (!problem.node) continue;
        const graph::Problem*& worst = found[problem.node];
        if (!worst || problem.severity > worst->severity) worst = &problem;
    }
    return found;
}

graph::SocketKind kind_at(const CanvasLayout& layout, const graph::LooseEnd& end)
{
    const CanvasNode* node = layout.find(end.node);
    if (!node) return graph::SocketKind::none;
    for (std::size_t row = 0; row < node->input_count(); ++row)
        if (node->input_name(row) == end.socket) return node->input_kind(row);
    return node->output;
}

void show_tooltip(const Theme& theme, const std::string& words, ImU32 text = colour::text)
{
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme.px(tooltip_width));
    ImGui::PushStyleColor(ImGuiCol_Text, text);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

void Canvas::paint(FrameContext& frame, const CanvasLayout& layout, const Hover& hover)
{
    CanvasPainter painter(*ImGui::GetWindowDrawList(), frame.theme, space_, frame.view.canvas.zoom);
    painter.grid();
    paint_wires(painter, frame, layout, hover);
    paint_nodes(painter, frame, layout, hover);
    paint_gesture(painter, layout);
}

void Canvas::paint_wires(CanvasPainter& painter, const FrameContext& frame, const CanvasLayout& layout,
                         const Hover& hover)
{
    const Wiring* wiring = hands_.doing<Wiring>();
    const MovingNodes* move = hands_.doing<MovingNodes>();
    const MovingWires* moved = hands_.doing<MovingWires>();
    const Selection& selection = frame.view.selection;
    for (const CanvasWire& wire : layout.wires()) {
        InputName input{wire.target, std::string(wire.socket)};
        WireLook look =
            selection.contains(wire.source) || selection.contains(wire.target) ? WireLook::selected : WireLook::plain;
        bool replaced = wiring && wiring->reason.empty() && wiring->target == input;
        if (wiring && wiring->detached == input) continue;
        if (moved && moved->from == wire.source) continue;
        if (wiring) look = replaced ? WireLook::faint : WireLook::plain;
        bool inserts = move && move->inserts && move->over == input;
        bool hovered = hands_.resting() && hover.kind == Hover::Kind::wire && hover.node == wire.target &&
                       hover.socket == wire.socket;
        if (inserts || hovered) look = WireLook::hovered;
        painter.wire(wire.curve, wire.kind, look);
    }
}

void Canvas::paint_nodes(CanvasPainter& painter, const FrameContext& frame, const CanvasLayout& layout,
                         const Hover& hover)
{
    std::map<NodeId, const graph::Problem*> problems = problems_by_node(frame.readings.problems);
    std::set<NodeId> selected = frame.view.selection.as_set();
    const graph::Group* open = graph::find_group(frame.draft.document, frame.draft.document.entered);
    NodeId output = open ? open->output : NodeId{};
    for (const CanvasNode& node : layout.nodes()) {
        if (!painter.visible(node.box)) continue;
        NodeId id = node.node->id;
        auto problem = problems.find(id);
        painter.node(node, {.selected = selected.contains(id),
                            .hovered = hover.node == id && hover.is_node(),
                            .problem = problem == problems.end() ? nullptr : problem->second,
                            .renamed = rename_.node == id});
        paint_pins(painter, node, hover);
        if (id == output) painter.caption(node.box, "Gives the group's result");
        const auto& costs = frame.readings.node_costs.by_node;
        auto cost = frame.view.node_costs ? costs.find(id) : costs.end();
        if (cost != costs.end()) painter.cost(node.box, duration_text(cost->second));
    }
}

void Canvas::paint_pins(CanvasPainter& painter, const CanvasNode& node, const Hover& hover)
{
    const Wiring* wiring = hands_.doing<Wiring>();
    NodeId id = node.node->id;
    auto look = [&](std::string_view socket) {
        if (wiring && wiring->target == InputName{id, std::string(socket)} && wiring->reason.empty())
            return PinLook::hovered;
        if (wiring && wiring->targets.end().node == id && wiring->targets.end().socket == socket)
            return PinLook::hovered;
        if (wiring) return wiring->targets.fits(id, socket) ? PinLook::glowing : PinLook::dim;
        return hover.is_pin() && hover.node == id && hover.socket == socket ? PinLook::hovered : PinLook::plain;
    };
    for (std::size_t row = 0; row < node.input_count(); ++row) {
        std::string_view socket = node.input_name(row);
        painter.pin(node.input_pin(row), node.input_kind(row), static_cast<bool>(node.node->input(socket)),
                    look(socket));
    }
    if (has_output(node.type)) painter.pin(node.output_pin(), node.output, true, look(""));
}

void Canvas::paint_gesture(CanvasPainter& painter, const CanvasLayout& layout)
{
    if (const BoxSelecting* box = hands_.doing<BoxSelecting>(); box && box->moved)
        painter.selection_box(box_between(box->from, box->to));
    if (const LassoSelecting* lasso = hands_.doing<LassoSelecting>()) painter.lasso(lasso->points);
    if (const Cutting* cut = hands_.doing<Cutting>()) painter.cut_stroke(cut->points);
    if (const MovingWires* moved = hands_.doing<MovingWires>()) paint_moving_wires(painter, layout, *moved);
    const Wiring* wiring = hands_.doing<Wiring>();
    if (!wiring) return;
    const graph::LooseEnd& end = wiring->targets.end();
    glm::vec2 from = loose_end_pin(layout, end), to = wiring->to;
    if (wiring->target && wiring->reason.empty())
        to = loose_end_pin(layout, {wiring->target->node, wiring->target->socket});
    WireCurve curve = end.socket.empty() ? wire_curve(from, to) : wire_curve(to, from);
    painter.wire(curve, kind_at(layout, end), wiring->reason.empty() ? WireLook::selected : WireLook::faint);
}

void Canvas::paint_moving_wires(CanvasPainter& painter, const CanvasLayout& layout, const MovingWires& moved)
{
    bool fits = moved.target && moved.reason.empty();
    glm::vec2 from = fits ? loose_end_pin(layout, {moved.target, ""}) : moved.to;
    for (const InputName& input : moved.inputs)
        painter.wire(wire_curve(from, loose_end_pin(layout, {input.node, input.socket})),
                     kind_at(layout, {moved.from, ""}), moved.reason.empty() ? WireLook::selected : WireLook::faint);
}

// Why a wire does not fit at once; names of things after a while.
void Canvas::tooltip(const FrameContext& frame, const CanvasLayout& layout, const Hover& hover)
{
    hover_s_ = hover == last_hover_ ? hover_s_ + ImGui::GetIO().DeltaTime : 0;
    last_hover_ = hover;
    if (const Wiring* wiring = hands_.doing<Wiring>(); wiring && !wiring->reason.empty())
        show_tooltip(frame.theme, graph::as_sentence(wiring->reason), colour::warning);
    if (const MovingWires* moved = hands_.doing<MovingWires>(); moved && !moved->reason.empty())
        show_tooltip(frame.theme, graph::as_sentence(moved->reason), colour::warning);
    const CanvasNode* node = layout.find(hover.node);
    if (!hands_.resting() || !node) return;
    auto problems = problems_by_node(frame.readings.problems);
    auto problem = problems.find(hover.node);
    bool has_problem = problem != problems.end(), full = detail_at(frame.view.canvas.zoom) == Detail::full;
    glm::vec2 mouse = space_.canvas({ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y});
    if (has_problem && hover.is_node() && (!full || problem_badge(node->box).contains(mouse))) {
        bool error = problem->second->severity == graph::Problem::Severity::error;
        show_tooltip(frame.theme, graph::as_sentence(problem->second->sentence),
                     error ? colour::error : colour::warning);
    } else if (hover_s_ < tooltip_delay_s) return;
    else if (hover.kind == Hover::Kind::input) show_tooltip(frame.theme, socket_hint(node->type, hover.socket));
    else if (hover.kind == Hover::Kind::output) show_tooltip(frame.theme, output_hint(node->type));
    else if (full && hover.is_node() && node->type && node->type->is_field() && node->type->category != "output" &&
             quality_badge(node->box, has_problem).contains(mouse))
        show_tooltip(frame.theme, quality_words(*node->type).sentence);
    else if (hover.kind == Hover::Kind::header && hover_s_ > help_delay_s)
        show_tooltip(frame.theme, node_hint(*node->node, node->type));
}

void Canvas::mark(FrameContext& frame, const CanvasLayout& layout) const
{
    if (!frame.rects.listening) return;
    auto around = [&](glm::vec2 p) {
        glm::vec2 at = space_.screen(p);
        return WidgetRect{at - 4.0f, at + 4.0f};
    };
    auto problems = problems_by_node(frame.readings.problems);
    Box pane = space_.pane_px();
    frame.rects.mark("canvas", {pane.low, pane.high});
    if (frame.view.minimap && minimap_.shown())
        frame.rects.mark("canvas/minimap", {minimap_.box_px().low, minimap_.box_px().high});
    for (const CanvasNode& node : layout.nodes()) {
        std::string name = "canvas/node/" + std::to_string(node.node->id.number);
        Box box = space_.screen(node.box);
        frame.rects.mark(name, {box.low, box.high});
        frame.rects.mark(name + "/header", {box.low, {box.high.x, box.low.y + node_header * space_.scale}});
        for (std::size_t row = 0; row < node.input_count(); ++row)
            frame.rects.mark(name + "/in/" + std::string(node.input_name(row)), around(node.input_pin(row)));
        if (has_output(node.type)) frame.rects.mark(name + "/out", around(node.output_pin()));
        if (problems.contains(node.node->id)) {
            Box badge = space_.screen(problem_badge(node.box));
            frame.rects.mark(name + "/problem", {badge.low, badge.high});
        }
    }
    for (const CanvasWire& wire : layout.wires())
        frame.rects.mark("canvas/wire/" + std::to_string(wire.target.number) + "/" + std::string(wire.socket),
                         around(wire.curve.at(0.5f)));
}

}  // namespace fieldwright::ui
