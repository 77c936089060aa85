// What may be wired to what: kinds of sockets, and the dimension that combiners adopt from what they are wired to.
#pragma once

#include "graph/edits.h"
#include "graph/words.h"

namespace fieldwright::graph {

struct WireEnd {
    const Node* node;
    const NodeType* type;  // null when unknown: then nothing is checked
};

// The rules over one graph, growing wire by wire. Fields of unknown type and their wires are not checked.
class WireRules {
public:
    // Knows the nodes of `graph` and none of its wires.
    WireRules(const Graph& graph, const Library& library, Wording wording = Wording::titles);

    // Adds a wire, or says why it is not allowed and adds nothing. Cycles are find_cycle's.
    Refusal add(NodeId source, NodeId target, std::string_view socket);
    // Adds every wire of the graph but the one to leave out. First refusal, or nothing.
    Refusal add_all(NodeId except_target = {}, std::string_view except_socket = {});
    int dimension(NodeId node);  // 2, 3, or 0 while nothing decides it

private:
    int index_of(NodeId id) const;  // -1 when absent
    int group(int index);
    WireEnd end(int index) const;
    Refusal join(int source, int target, const Socket& socket);

    const Graph& graph_;
    Wording wording_;
    std::vector<const NodeType*> types_;  // by node index; null when unknown
    // Combiners wired to each other share a dimension: disjoint sets by node index.
    std::vector<int> parent_;
    std::vector<int> dimension_;  // of a set, at its root
};

// Why the socket does not take what `from` gives, dimensions apart; or nothing.
Refusal kind_error(const WireEnd& from, const WireEnd& to, std::string_view socket, Wording wording = Wording::titles);
// Why a field of dimension `given` cannot feed an input of dimension `taken`; nothing when either is undecided (0).
Refusal dimension_error(const WireEnd& from, int given, const WireEnd& to, int taken, std::string_view socket,
                        Wording wording = Wording::titles);
bool carries_field(SocketKind kind);
bool kinds_fit(SocketKind from, SocketKind to);  // dimensions apart
int dimension_of(SocketKind kind);               // 2, 3, or 0 for a field of any dimension

// "node 3 (`sphere`)"
std::string described(const Node& node);
// "`a`, `b`"; "none" when there are none.
std::string socket_names(const NodeType& type);
std::string parameter_names(const NodeType& type);
// Nodes of a cycle in order, or empty. O(nodes + wires).
std::vector<NodeId> find_cycle(const Graph& graph);
// "3 -> 5 -> 3", along the flow; long cycles are cut.
std::string cycle_text(const std::vector<NodeId>& cycle);

}  // namespace fieldwright::graph
