// What a wire in the hand could be wired to.
#include "graph/draft.h"
#include "graph/wire_rules.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

// What an input takes: its kind, with the dimension that its node has when the wire to be replaced is gone.
Offer taken_by(const Document& document, const Library& library, const LooseEnd& end)
{
    const Node* node = document.root.find(end.node);
    const NodeType* type = node ? library.type(node->type) : nullptr;
    const Socket* socket = type ? type->input(end.socket) : nullptr;
    if (!socket) return {};
    if (socket->kind != SocketKind::field_any) return {socket->kind, dimension_of(socket->kind)};
    WireRules rules(document.root, library);
    rules.add_all(end.node, end.socket);
    return {socket->kind, rules.dimension(end.node)};
}

bool gives(const NodeType& type, const Offer& taken)
{
    int given = dimension_of(type.output);
    return !is_output(type) && kinds_fit(type.output, taken.kind) &&
           (!given || !taken.dimension || given == taken.dimension);
}

// No second output: it would not be drawn.
bool allowed(const Document& document, const Library& library, const NodeType& type)
{
    return !is_output(type) || !shown_output(document, library);
}

}  // namespace

std::vector<Fit> fits(const Document& document, const Library& library, const LooseEnd& end)
{
    std::vector<Fit> found;
    bool from_output = end.socket.empty();
    Offer offer = from_output ? offer_of(document, library, end.node) : taken_by(document, library, end);
    if (offer.kind == SocketKind::none) return found;
    for (const NodeType* type : library.types()) {
        if (!from_output && gives(*type, offer)) found.push_back({type, {}});
        const Socket* socket = from_output ? first_input_for(*type, offer) : nullptr;
        if (socket && allowed(document, library, *type)) found.push_back({type, socket->name});
    }
    return found;
}

Placed add_wired(Document& document, const Library& library, std::string_view name, glm::vec2 position,
                 const LooseEnd& end)
{
    const Node* node = document.root.find(end.node);
    if (!node) return {{}, "there is no node " + std::to_string(end.node.number)};
    std::vector<Fit> found = fits(document, library, end);
    auto fit = std::find_if(found.begin(), found.end(), [name](const Fit& one) { return one.type->name == name; });
    const NodeType *type = library.type(name), *node_type = library.type(node->type);
    if (fit == found.end())
        return {{},
                titled(type ? type->title : name) + " cannot be wired to " +
                    (end.socket.empty() ? "" : titled(socket_label(node_type, end.socket)) + " of ") +
                    titled(node_title(*node, node_type))};
    Draft draft(document, library);
    NodeId added = draft.add(name, position);
    if (end.socket.empty()) draft.wire(end.node, added, fit->socket);
    else draft.wire(added, end.node, end.socket);
    return draft.finish(added);
}

}  // namespace fieldwright::graph
