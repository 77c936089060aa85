// Edits by hand.
#include "ui/canvas_edits.h"

#include "ui/add_menu.h"
#include "ui/canvas_hands.h"
#include "ui/lamp_place.h"
#include "ui/node_words.h"

#include "graph/group_edits.h"

namespace fieldwright::ui {

using graph::NodeId;

namespace {

std::string counted(const char* verb, std::size_t count, const std::string& one)
{
    return verb + (" " + (count == 1 ? one : std::to_string(count) + " " + one + "s"));
}

// Of the user's library; null when the type is none of it.
const SavedGroup* saved_group(const Readings& readings, const graph::NodeType& type)
{
    for (const SavedGroup& saved : readings.saved_groups)
        if (&saved.type == &type) return &saved;
    return nullptr;
}

}  // namespace

void move_selection(FrameContext& frame, glm::vec2 by)
{
    const Selection& selection = frame.view.selection;
    frame.draft.done(counted("Move", selection.nodes().size(), "node"),
                     graph::move_nodes(frame.draft.document, selection.as_set(), by));
}

bool can_insert(const Draft& draft, NodeId node, NodeId target, const std::string& socket)
{
    for (const graph::Node& reader : draft.document.root.nodes)
        for (const auto& [_, source] : reader.inputs)
            if (source == node) return false;
    graph::Document trial = draft.document;
    return !graph::insert_on_wire(trial, draft.library, node, target, socket);
}

void move_onto_wire(FrameContext& frame, glm::vec2 by, NodeId target, const std::string& socket)
{
    graph::Document trial = frame.draft.document;
    graph::Refusal refused = graph::move_nodes(trial, frame.view.selection.as_set(), by);
    if (!refused)
        refused = graph::insert_on_wire(trial, frame.draft.library, frame.view.selection.active(), target, socket);
    if (frame.draft.done("Insert into wire", refused)) frame.draft.document = std::move(trial);
}

graph::Refusal move_wires(graph::Document& document, const graph::Library& library, const MovingWires& wires)
{
    std::vector<graph::Wire> wanted;
    for (const InputName& input : wires.inputs) wanted.push_back({wires.target, input.node, input.socket});
    return graph::connect_all(document, library, wanted);
}

void cut_wires(FrameContext& frame, const std::vector<InputName>& inputs)
{
    if (inputs.empty()) return;
    graph::Document trial = frame.draft.document;
    graph::Refusal refused;
    for (const InputName& input : inputs)
        if (!refused) refused = graph::disconnect(trial, input.node, input.socket);
    if (frame.draft.done(counted("Cut", inputs.size(), "wire"), refused)) frame.draft.document = std::move(trial);
}

void break_wires(FrameContext& frame, const Hover& pin)
{
    std::vector<InputName> inputs;
    for (const graph::Node& node : frame.draft.document.root.nodes)
        for (const auto& [socket, source] : node.inputs) {
            bool ends_here = pin.kind == Hover::Kind::input && node.id == pin.node && socket == pin.socket;
            bool starts_here = pin.kind == Hover::Kind::output && source == pin.node;
            if (ends_here || starts_here) inputs.push_back({node.id, socket});
        }
    cut_wires(frame, inputs);
}

glm::vec2 loose_end_pin(const CanvasLayout& layout, const graph::LooseEnd& end)
{
    const CanvasNode* node = layout.find(end.node);
    if (!node) return {0, 0};
    for (std::size_t row = 0; row < node->input_count(); ++row)
        if (!end.socket.empty() && node->input_name(row) == end.socket) return node->input_pin(row);
    return node->output_pin();
}

NodeId add_at(FrameContext& frame, const graph::NodeType& type, const AddPlace& place)
{
    graph::Document trial = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    graph::Placed placed;
    if (place.end) {
        // Its pin, not its corner, comes to where the wire was dropped.
        glm::vec2 pin = place.end->socket.empty() ? input_offset(0) : output_offset();
        placed = graph::add_wired(trial, library, type.name, place.position - pin, *place.end);
    } else if (place.on_wire) {
        placed = graph::add_alone(trial, library, type.name, place.position);
        if (!placed.refusal)
            placed.refusal =
                graph::insert_on_wire(trial, library, placed.node, place.on_wire->node, place.on_wire->socket);
    } else if (const SavedGroup* saved = saved_group(frame.readings, type))
        placed = graph::add_saved_group(trial, library, saved->text, place.position, frame.view.selection.nodes());
    else placed = graph::add_from_menu(trial, library, type.name, place.position, frame.view.selection.nodes());
    if (!frame.draft.done("Add " + graph::inside_a_sentence(type.title), placed.refusal)) return {};
    place_lamp(frame, trial, placed.node);
    frame.draft.document = std::move(trial);
    frame.view.selection.only(placed.node);
    return placed.node;
}

}  // namespace fieldwright::ui
