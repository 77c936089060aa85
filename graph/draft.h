// A copy of a document to try a compound edit on; it replaces the document only when nothing was refused.
#pragma once

#include "graph/compose.h"
#include "graph/neighbours.h"

namespace fieldwright::graph {

class Draft {
public:
    Draft(Document& document, const Library& library) : original_(document), draft_(document), library_(library) {}

    const Document& document() const { return draft_; }
    Document& document() { return draft_; }
    const Library& library() const { return library_; }
    const Node& node(NodeId id) const { return *draft_.root.find(id); }
    bool refused() const { return refusal_.has_value(); }
    void refuse(Refusal refusal);  // the first reason stays

    // NodeId{} when refused, which later steps pass over.
    NodeId add(std::string_view type, glm::vec2 position);
    // A new node of one field input in the column after `source`, which it reads.
    NodeId append(NodeId source, std::string_view type);
    // Wires are made together, at the end or by `make_wires`.
    void wire(NodeId source, NodeId target, std::string_view socket);
    // What reads `source` reads `heir` from now on; nodes of unknown type stay as they are.
    void hand_over(std::span<const Wire> readers, NodeId heir);
    // Inside a group: what was its output hands that on too.
    void hand_over_output(NodeId before, NodeId heir);
    void set(NodeId node, std::string_view parameter, Value value);
    // Moves everything that hangs on `readers` right, when the nearest of it is not a column away from `node`.
    void make_room(NodeId node, const Readers& all_readers, std::span<const Wire> readers);
    void make_wires();

    Placed finish(NodeId node);  // the edit is done or refused

private:
    Document& original_;
    Document draft_;
    const Library& library_;
    std::vector<Wire> wires_;
    Refusal refusal_;
};

}  // namespace fieldwright::graph
