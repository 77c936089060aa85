// A document without groups that means the same: every group node replaced by copies of what is inside.
#pragma once

#include "graph/groups.h"
#include "graph/library.h"

#include <map>

namespace fieldwright::graph {

// A copy of an inner node, and the way to the original: the group node in the scene, ..., the inner node.
struct InnerCopy {
    NodeId copy;
    std::vector<NodeId> path;
    bool operator==(const InnerCopy&) const = default;
};

struct Expansion {
    Document document;              // nodes of the scene keep their ids; copies have ids from next_id on
    std::vector<InnerCopy> copies;  // sorted by copy
    // For each group node, and for each node inside groups, what stands for it in `document`: the copy of the group's
    // output, or the first copy. Missing when there is none.
    std::map<NodeId, NodeId> stand_ins;
    std::vector<Problem> problems;  // more copies than node_limit: the rest of the groups counts as unconnected
};

// Of a document at rest. Only what a group's output is made of is copied. An exposed parameter's value takes the place of
// the inner one, a wire from outside that of a wire inside; muted groups pass their first field on. Deterministic.
Expansion expanded(const Document& document, const Library& library);

// Where a node of a program came from: the way into groups of a copy, or the node alone.
std::vector<NodeId> path_of(const std::vector<InnerCopy>& copies, NodeId node);
// The first of them that a graph shows; NodeId{} when it shows none.
NodeId shown_on(const std::vector<NodeId>& path, const Graph& graph);

}  // namespace fieldwright::graph
