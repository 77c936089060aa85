// Asking the rules of wires about every pin at once.
#include "ui/wire_targets.h"

#include "graph/wire_rules.h"
#include "graph/words.h"

#include <map>

namespace fieldwright::ui {

using graph::NodeId;

namespace {

using Neighbours = std::map<NodeId, std::vector<NodeId>>;

std::set<NodeId> reached(const Neighbours& neighbours, NodeId start)
{
    std::set<NodeId> found{start};
    std::vector<NodeId> open{start};
    while (!open.empty()) {
        auto next = neighbours.find(open.back());
        open.pop_back();
        if (next == neighbours.end()) continue;
        for (NodeId id : next->second)
            if (found.insert(id).second) open.push_back(id);
    }
    return found;
}

// What a node is made from, itself included.
std::set<NodeId> upstream(const graph::Graph& graph, NodeId start)
{
    Neighbours sources;
    for (const graph::Node& node : graph.nodes)
        for (const auto& [_, source] : node.inputs) sources[node.id].push_back(source);
    return reached(sources, start);
}

std::set<NodeId> downstream(const graph::Graph& graph, NodeId start)
{
    Neighbours readers;
    for (const graph::Node& node : graph.nodes)
        for (const auto& [_, source] : node.inputs) readers[source].push_back(node.id);
    return reached(readers, start);
}

// The quick answer, by kinds and by the dimensions of the whole graph. A wire that would be replaced may be what
// decides a dimension: only then the exact question is asked.
bool fits_together(const graph::Document& document, const graph::Library& library, graph::WireRules& rules,
                   const graph::WireEnd& from, const graph::WireEnd& to, const std::string& socket)
{
    if (from.type && from.type->output == graph::SocketKind::none) return false;
    if (graph::kind_error(from, to, socket)) return false;
    if (!from.type || !from.type->is_field()) return true;
    const graph::Socket& input = *to.type->input(socket);
    int taken =
        input.kind == graph::SocketKind::field_any ? rules.dimension(to.node->id) : graph::dimension_of(input.kind);
    if (!graph::dimension_error(from, rules.dimension(from.node->id), to, taken, socket)) return true;
    return to.node->input(socket) && !graph::wire_error(document, library, from.node->id, to.node->id, socket);
}

}  // namespace

WireTargets::WireTargets(graph::Document document, const graph::Library& library, graph::LooseEnd end)
    : document_(std::move(document)), end_(std::move(end))
{
    if (end_.socket.empty()) find_inputs(library);
    else find_outputs(library);
}

void WireTargets::find_inputs(const graph::Library& library)
{
    const graph::Node* source = document_.root.find(end_.node);
    if (!source) return;
    graph::WireRules rules(document_.root, library);
    if (rules.add_all()) return;
    graph::WireEnd from{source, library.type(source->type)};
    std::set<NodeId> makes_it = upstream(document_.root, end_.node);
    for (const graph::Node& node : document_.root.nodes) {
        const graph::NodeType* type = library.type(node.type);
        if (!type || makes_it.contains(node.id)) continue;
        for (const graph::Socket& input : type->inputs)
            if (fits_together(document_, library, rules, from, {&node, type}, input.name))
                fitting_.insert({node.id, input.name});
    }
}

void WireTargets::find_outputs(const graph::Library& library)
{
    const graph::Node* target = document_.root.find(end_.node);
    if (!target || !library.type(target->type)) return;
    graph::WireRules rules(document_.root, library);
    if (rules.add_all()) return;
    graph::WireEnd to{target, library.type(target->type)};
    std::set<NodeId> reads_it = downstream(document_.root, end_.node);
    for (const graph::Node& node : document_.root.nodes)
        if (!reads_it.contains(node.id) &&
            fits_together(document_, library, rules, {&node, library.type(node.type)}, to, end_.socket))
            fitting_.insert({node.id, ""});
}

bool WireTargets::fits(NodeId node, std::string_view socket) const
{
    return fitting_.contains(std::pair<NodeId, std::string>(node, socket));
}

graph::Refusal WireTargets::connect(graph::Document& document, const graph::Library& library, NodeId node,
                                    std::string_view socket) const
{
    if (end_.socket.empty() != socket.empty())
        return end_.socket.empty() ? graph::connect(document, library, end_.node, node, socket)
                                   : graph::connect(document, library, node, end_.node, end_.socket);
    return end_.socket.empty() ? "two outputs cannot be wired to each other; end the wire on an input"
                               : "two inputs cannot be wired to each other; end the wire on an output";
}

// Of a node; empty when there is none.
std::string WireTargets::fitting_input(const graph::NodeType& type, NodeId node) const
{
    for (const graph::Socket& input : type.inputs)
        if (fits(node, input.name)) return input.name;
    return {};
}

std::string WireTargets::reason(const graph::Library& library, NodeId node, std::string_view socket) const
{
    graph::Document trial = document_;
    std::string why = connect(trial, library, node, socket).value_or("");
    const graph::NodeType* type = library.type(document_.root.find(node)->type);
    bool may_help = !why.empty() && type && end_.socket.empty() && !socket.empty();
    std::string better = may_help ? fitting_input(*type, node) : "";
    return better.empty() ? why : why + "; " + graph::titled(graph::socket_label(type, better)) + " takes it";
}

// The input that comes nearest says why: one of the right kind, if there is one.
std::string WireTargets::reason(const graph::Library& library, NodeId id) const
{
    if (!end_.socket.empty()) return reason(library, id, "");
    const graph::Node *source = document_.root.find(end_.node), *node = document_.root.find(id);
    const graph::NodeType *from = library.type(source->type), *to = library.type(node->type);
    std::string target = graph::titled(graph::node_title(*node, to));
    if (!to) return target + " is of a type this version does not know; nothing can be wired to it";
    for (const graph::Socket& input : to->inputs)
        if (!graph::kind_error({source, from}, {node, to}, input.name)) return reason(library, id, input.name);
    std::string given = graph::kind_named(graph::Wording::titles, from ? from->output : graph::SocketKind::none);
    return "no input of " + target + " takes " + given + ", which " + graph::titled(graph::node_title(*source, from)) +
           " gives";
}

}  // namespace fieldwright::ui
