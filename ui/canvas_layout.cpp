// Laying out nodes and wires, and looking them up by place.
#include "ui/canvas_layout.h"

#include "graph/leader.h"

#include <algorithm>

namespace fieldwright::ui {

using graph::NodeId;

std::string_view CanvasNode::input_name(std::size_t row) const
{
    return type ? std::string_view(type->inputs[rows.input(row)].name) : std::string_view(node->inputs[row].first);
}

graph::SocketKind CanvasNode::input_kind(std::size_t row) const
{
    return type ? type->inputs[rows.input(row)].kind : graph::SocketKind::none;
}

CanvasLayout::CanvasLayout(const graph::Graph& graph, const graph::Library& library, const Selection& selection,
                           glm::vec2 drag)
{
    nodes_.reserve(graph.nodes.size());
    std::set<NodeId> selected = selection.as_set();
    for (bool front : {false, true})
        for (const graph::Node& node : graph.nodes) {
            if (selected.contains(node.id) != front) continue;
            const graph::NodeType* type = library.type(node.type);
            glm::vec2 low = node.position + (front ? drag : glm::vec2(0));
            nodes_.push_back(
                {&node, type, {low, low + node_size(node, type)}, type ? type->output : graph::SocketKind::none});
            const graph::Node* leader = type ? graph::leader_of(graph, node, *type) : nullptr;
            nodes_.back().leader = leader;
            nodes_.back().leader_type = leader ? library.type(leader->type) : nullptr;
        }
    by_id_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) by_id_[i] = i;
    std::sort(by_id_.begin(), by_id_.end(),
              [&](std::size_t a, std::size_t b) { return nodes_[a].node->id < nodes_[b].node->id; });
    place_wires();
}

void CanvasLayout::place_wires()
{
    for (const CanvasNode& target : nodes_)
        for (std::size_t row = 0; row < target.input_count(); ++row) {
            std::string_view socket = target.input_name(row);
            const CanvasNode* source = target.node->inputs.empty() ? nullptr : find(target.node->input(socket));
            if (!source) continue;
            wires_.push_back({source->node->id, target.node->id, socket, source->output,
                              wire_curve(source->output_pin(), target.input_pin(row))});
        }
}

const CanvasNode* CanvasLayout::find(NodeId id) const
{
    auto found = std::lower_bound(by_id_.begin(), by_id_.end(), id,
                                  [&](std::size_t index, NodeId wanted) { return nodes_[index].node->id < wanted; });
    return found != by_id_.end() && nodes_[*found].node->id == id ? &nodes_[*found] : nullptr;
}

const CanvasWire* CanvasLayout::wire(NodeId target, std::string_view socket) const
{
    for (const CanvasWire& wire : wires_)
        if (wire.target == target && wire.socket == socket) return &wire;
    return nullptr;
}

std::optional<Box> CanvasLayout::bounds() const
{
    if (nodes_.empty()) return std::nullopt;
    Box box = nodes_.front().box;
    for (const CanvasNode& node : nodes_) box = box.with(node.box);
    return box;
}

std::optional<Box> CanvasLayout::bounds(const std::vector<NodeId>& ids) const
{
    std::optional<Box> box;
    for (NodeId id : ids)
        if (const CanvasNode* node = find(id)) box = box ? box->with(node->box) : node->box;
    return box;
}

std::optional<Hover> CanvasLayout::pin_at(const CanvasNode& node, glm::vec2 p, float reach) const
{
    if (!node.box.grown(reach).contains(p)) return std::nullopt;
    std::optional<Hover> nearest;
    auto consider = [&](glm::vec2 pin, Hover::Kind kind, std::string_view socket) {
        float distance = glm::length(p - pin);
        if (distance > reach) return;
        reach = distance;
        nearest = Hover{kind, node.node->id, std::string(socket)};
    };
    if (has_output(node.type)) consider(node.output_pin(), Hover::Kind::output, {});
    for (std::size_t row = 0; row < node.input_count(); ++row)
        consider(node.input_pin(row), Hover::Kind::input, node.input_name(row));
    return nearest;
}

Hover CanvasLayout::at(glm::vec2 p, float pin_reach, float wire_reach) const
{
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
        if (auto pin = pin_at(*node, p, pin_reach)) return *pin;
        if (!node->box.contains(p)) continue;
        bool header = p.y < node->box.low.y + node_header;
        return {header ? Hover::Kind::header : Hover::Kind::body, node->node->id, {}};
    }
    Hover nearest;
    for (const CanvasWire& wire : wires_) {
        if (!wire.curve.box().grown(wire_reach).contains(p)) continue;
        float distance = distance_to(wire.curve, p);
        if (distance > wire_reach) continue;
        wire_reach = distance;
        nearest = {Hover::Kind::wire, wire.target, std::string(wire.socket)};
    }
    return nearest;
}

std::vector<NodeId> CanvasLayout::inside(const Box& box) const
{
    std::vector<NodeId> ids;
    for (std::size_t index : by_id_)
        if (nodes_[index].box.touches(box)) ids.push_back(nodes_[index].node->id);
    return ids;
}

std::vector<NodeId> CanvasLayout::inside(const std::vector<glm::vec2>& outline) const
{
    std::vector<NodeId> ids;
    for (std::size_t index : by_id_)
        if (encloses(outline, nodes_[index].box.centre())) ids.push_back(nodes_[index].node->id);
    return ids;
}

const CanvasWire* CanvasLayout::wire_through(NodeId id) const
{
    const CanvasNode* node = find(id);
    if (!node) return nullptr;
    for (const CanvasWire& wire : wires_)
        if (wire.source != id && wire.target != id && passes_through(wire.curve, node->box)) return &wire;
    return nullptr;
}

}  // namespace fieldwright::ui
