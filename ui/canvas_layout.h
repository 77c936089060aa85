// Where every node and wire of a document lies on the canvas in this frame, and what is under a point of it.
#pragma once

#include "ui/node_geometry.h"
#include "ui/selection.h"

namespace fieldwright::ui {

struct CanvasNode {
    const graph::Node* node;
    const graph::NodeType* type;  // null when unknown
    Box box;
    graph::SocketKind output;  // of unknown types: none

    InputRows rows{*node, type};
    const graph::Node* leader = nullptr;  // whose parameters it follows (graph/leader.h), and that one's type
    const graph::NodeType* leader_type = nullptr;

    std::size_t input_count() const { return rows.count(); }
    std::string_view input_name(std::size_t row) const;
    graph::SocketKind input_kind(std::size_t row) const;
    glm::vec2 input_pin(std::size_t row) const { return box.low + input_offset(row); }
    glm::vec2 output_pin() const { return box.low + output_offset(); }
};

struct CanvasWire {
    graph::NodeId source, target;
    std::string_view socket;  // of the target
    graph::SocketKind kind;
    WireCurve curve;
};

// What is under the mouse.
struct Hover {
    enum class Kind { nothing, output, input, header, body, wire } kind = Kind::nothing;
    graph::NodeId node;  // of a wire: its target
    std::string socket;  // of an input, or of a wire's target
    bool operator==(const Hover&) const = default;

    bool is_pin() const { return kind == Kind::output || kind == Kind::input; }
    bool is_node() const { return kind == Kind::header || kind == Kind::body; }
    bool is_empty() const { return kind == Kind::nothing || kind == Kind::wire; }
};

// Refers to the document it was made from: valid until that changes.
class CanvasLayout {
public:
    // `drag`: how far the hand has moved the selected nodes.
    CanvasLayout(const graph::Graph& graph, const graph::Library& library, const Selection& selection,
                 glm::vec2 drag = {0, 0});

    const std::vector<CanvasNode>& nodes() const { return nodes_; }  // back to front: the selected ones in front
    const std::vector<CanvasWire>& wires() const { return wires_; }
    const CanvasNode* find(graph::NodeId id) const;
    const CanvasWire* wire(graph::NodeId target, std::string_view socket) const;
    std::optional<Box> bounds() const;
    std::optional<Box> bounds(const std::vector<graph::NodeId>& ids) const;

    // `reach`: how near is near enough, of pins and of wires.
    Hover at(glm::vec2 p, float pin_reach, float wire_reach) const;
    std::vector<graph::NodeId> inside(const Box& box) const;                         // nodes it touches
    std::vector<graph::NodeId> inside(const std::vector<glm::vec2>& outline) const;  // nodes with their middle in it
    // The wire that passes through a node, without being one of its own.
    const CanvasWire* wire_through(graph::NodeId node) const;

private:
    void place_wires();
    std::optional<Hover> pin_at(const CanvasNode& node, glm::vec2 p, float reach) const;

    std::vector<CanvasNode> nodes_;
    std::vector<CanvasWire> wires_;
    std::vector<std::size_t> by_id_;  // indices of nodes_ in the order of ids
};

}  // namespace fieldwright::ui
