// Looks around in a graph.
#include "graph/neighbours.h"

#include "graph/wire_rules.h"

#include <algorithm>
#include <tuple>

namespace fieldwright::graph {

Readers::Readers(const Graph& graph)
{
    for (const Node& node : graph.nodes)
        for (const auto& [socket, source] : node.inputs) wires_.push_back({source, node.id, socket});
    std::sort(wires_.begin(), wires_.end(), [](const Wire& a, const Wire& b) {
        return std::tie(a.source, a.target, a.socket) < std::tie(b.source, b.target, b.socket);
    });
}

std::span<const Wire> Readers::of(NodeId source) const
{
    auto first = std::lower_bound(wires_.begin(), wires_.end(), source,
                                  [](const Wire& wire, NodeId id) { return wire.source < id; });
    auto last =
        std::upper_bound(first, wires_.end(), source, [](NodeId id, const Wire& wire) { return id < wire.source; });
    return {first, last};
}

Offer offer_of(const Document& document, const Library& library, NodeId id)
{
    const Node* node = document.root.find(id);
    const NodeType* type = node ? library.type(node->type) : nullptr;
    if (!type) return {};
    return {type->output, type->is_field() ? field_dimension(document, library, id) : 0};
}

bool takes(SocketKind input, const Offer& offer)
{
    if (!kinds_fit(offer.kind, input)) return false;
    int taken = dimension_of(input);
    return !taken || !offer.dimension || taken == offer.dimension;
}

bool is_output(const NodeType& type) { return type.category == "output"; }

bool is_operator(const NodeType& type) { return type.is_field() && !is_output(type) && !field_inputs(type).empty(); }

bool is_shape(const NodeType& type) { return type.is_field() && !is_output(type) && field_inputs(type).empty(); }

std::vector<std::string> field_inputs(const NodeType& type)
{
    std::vector<std::string> names;
    for (const Socket& socket : type.inputs)
        if (carries_field(socket.kind)) names.push_back(socket.name);
    return names;
}

const Socket* first_input_for(const NodeType& type, const Offer& offer, const Node* occupied)
{
    for (const Socket& socket : type.inputs)
        if (takes(socket.kind, offer) && !(occupied && occupied->input(socket.name))) return &socket;
    return nullptr;
}

const Node* shown_output(const Document& document, const Library& library)
{
    for (const Node& node : document.root.nodes) {
        const NodeType* type = library.type(node.type);
        if (type && is_output(*type)) return &node;
    }
    return nullptr;
}

std::vector<NodeId> own_way(const Document& document, const Library& library, NodeId start)
{
    Readers readers(document.root);
    std::vector<NodeId> way;
    const Node* node = document.root.find(start);
    for (const NodeType* type = node ? library.type(node->type) : nullptr; type && type->is_field();) {
        if (is_output(*type) || (!way.empty() && field_inputs(*type).size() != 1)) break;
        way.push_back(node->id);
        std::span<const Wire> wires = readers.of(node->id);
        if (wires.size() != 1) break;
        node = document.root.find(wires.front().target);
        type = library.type(node->type);
    }
    return way;
}

}  // namespace fieldwright::graph
