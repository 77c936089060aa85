// Look-ups in a document.
#include "graph/document.h"

#include <algorithm>

namespace fieldwright::graph {

const Value* Node::parameter(std::string_view parameter_name) const
{
    for (const auto& [key, value] : parameters)
        if (key == parameter_name) return &value;
    return nullptr;
}

NodeId Node::input(std::string_view socket) const
{
    for (const auto& [name_of_socket, source] : inputs)
        if (name_of_socket == socket) return source;
    return {};
}

const Node* Graph::find(NodeId id) const
{
    auto found =
        std::lower_bound(nodes.begin(), nodes.end(), id, [](const Node& node, NodeId key) { return node.id < key; });
    return found != nodes.end() && found->id == id ? &*found : nullptr;
}

Node* Graph::find(NodeId id) { return const_cast<Node*>(std::as_const(*this).find(id)); }

}  // namespace fieldwright::graph
