// What lies around a node: its readers, the output, the input that would take it. Asked by edits that span nodes.
#pragma once

#include "graph/edits.h"

#include <span>

namespace fieldwright::graph {

// Every wire of a graph, found by its source.
class Readers {
public:
    explicit Readers(const Graph& graph);           // O(wires log wires)
    std::span<const Wire> of(NodeId source) const;  // by target, then socket

private:
    std::vector<Wire> wires_;
};

// What a node gives, as far as wiring goes.
struct Offer {
    SocketKind kind = SocketKind::none;
    int dimension = 0;  // of a field; 0 while nothing decides it
};
Offer offer_of(const Document& document, const Library& library, NodeId node);  // kind none when unknown
bool takes(SocketKind input, const Offer& offer);

bool is_operator(const NodeType& type);  // makes a field of fields; an output is none
bool is_shape(const NodeType& type);     // a field made of nothing
bool is_output(const NodeType& type);
std::vector<std::string> field_inputs(const NodeType& type);
// The first of the type's inputs that takes what is offered; inputs that `occupied` has wired are passed over.
const Socket* first_input_for(const NodeType& type, const Offer& offer, const Node* occupied = nullptr);

// The output node that is drawn; null when there is none.
const Node* shown_output(const Document& document, const Library& library);
// The nodes that this node's surface passes on its way to the output, itself first, up to the first combiner, output
// or place where several nodes read it. Empty when the node is no field.
std::vector<NodeId> own_way(const Document& document, const Library& library, NodeId node);

}  // namespace fieldwright::graph
