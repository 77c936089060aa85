// Leaders: nodes whose parameters others take over, as a sky does the sun's (`// follows: TYPE while SWITCH`).
#pragma once

#include "graph/document.h"
#include "graph/library.h"

namespace fieldwright::graph {

// Whether a node's type follows another and the node wants it.
bool wants_leader(const Node& node, const NodeType& type);
// The first unmuted node of the type that it follows, by id; null without one, and for nodes that follow none.
const Node* leader_of(const Graph& graph, const Node& node, const NodeType& type);
// Whether a leader gives its parameter of that name: both types have it, alike, and nothing is wired to the follower's.
bool is_led(const Node& node, const Parameter& parameter, const NodeType& leader);

}  // namespace fieldwright::graph
