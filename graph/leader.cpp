#include "graph/leader.h"

#include <algorithm>

namespace fieldwright::graph {

bool wants_leader(const Node& node, const NodeType& type)
{
    if (type.follows.empty()) return false;
    const Value* wanted = node.parameter(type.follows_while);
    const bool* on = wanted ? std::get_if<bool>(wanted) : nullptr;
    return on ? *on : std::get<bool>(type.parameter(type.follows_while)->initial);
}

const Node* leader_of(const Graph& graph, const Node& node, const NodeType& type)
{
    if (!wants_leader(node, type)) return nullptr;
    auto leads = [&](const Node& other) { return other.type == type.follows && !other.muted; };
    auto found = std::find_if(graph.nodes.begin(), graph.nodes.end(), leads);
    return found == graph.nodes.end() ? nullptr : &*found;
}

bool is_led(const Node& node, const Parameter& parameter, const NodeType& leader)
{
    const Parameter* given = leader.parameter(parameter.name);
    return given && given->kind == parameter.kind && !node.input(parameter.name);
}

}  // namespace fieldwright::graph
