// The edits: each checks first and changes the document only when nothing speaks against it.
#include "graph/edits.h"

#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/limits.h"
#include "graph/settings.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fieldwright::graph {
namespace {

bool is_finite(glm::vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

std::string no_node(NodeId id) { return "there is no node " + std::to_string(id.number); }

// A node of unknown type is its source text; an edit would be lost on save.
Refusal placeholder_error(const Node& node)
{
    if (node.unknown_source.empty()) return std::nullopt;
    return titled(node_title(node, nullptr)) +
           " is of a type this version does not know and is kept as it is; delete it or open the "
           "scene with a newer version";
}

// The node, when it may be edited; else `refusal` says why not.
Node* editable(Document& document, NodeId id, Refusal& refusal)
{
    Node* node = document.root.find(id);
    refusal = node ? placeholder_error(*node) : no_node(id);
    return refusal ? nullptr : node;
}

auto input_place(Node& node, std::string_view socket)
{
    return std::lower_bound(node.inputs.begin(), node.inputs.end(), socket,
                            [](const auto& input, std::string_view name) { return input.first < name; });
}

bool feeds_something(const Graph& graph, NodeId id)
{
    auto uses = [id](const auto& input) { return input.second == id; };
    return std::any_of(graph.nodes.begin(), graph.nodes.end(),
                       [&](const Node& node) { return std::any_of(node.inputs.begin(), node.inputs.end(), uses); });
}

std::size_t wire_count(const Graph& graph)
{
    std::size_t count = 0;
    for (const Node& node : graph.nodes) count += node.inputs.size();
    return count;
}

// Visits what `start` is made of, itself first, until `visit` returns true. `visit` is asked once per node.
template <typename Visit>
bool visit_upstream(const Graph& graph, NodeId start, Visit visit)
{
    std::vector<bool> seen(graph.nodes.size());
    std::vector<const Node*> stack = {graph.find(start)};
    while (!stack.empty()) {
        const Node* node = stack.back();
        stack.pop_back();
        auto index = static_cast<std::size_t>(node - graph.nodes.data());
        if (seen[index]) continue;
        seen[index] = true;
        if (visit(*node)) return true;
        for (const auto& [socket, from] : node->inputs) stack.push_back(graph.find(from));
    }
    return false;
}

// Whether `source` is made of `target`. A node that feeds nothing, the usual target, is part of nothing but itself.
bool reaches(const Graph& graph, NodeId source, NodeId target)
{
    if (source == target) return true;
    return feeds_something(graph, target) &&
           visit_upstream(graph, source, [target](const Node& node) { return node.id == target; });
}

// The dimension of a combiner as the first fixed field among what it is made of says; 0 when none is near.
int upstream_dimension(const Graph& graph, const Library& library, NodeId start)
{
    std::vector<const Node*> stack = {graph.find(start)};
    for (int budget = 64; !stack.empty() && budget > 0; --budget) {
        const Node* node = stack.back();
        stack.pop_back();
        const NodeType* type = library.type(node->type);
        if (!type || !type->is_field()) continue;
        if (int dimension = dimension_of(type->output)) return dimension;
        for (const auto& [socket, from] : node->inputs) {
            const Socket* input = type->input(socket);
            if (!input || input->kind != SocketKind::field_any) continue;
            stack.push_back(graph.find(from));
            const NodeType* source = library.type(stack.back()->type);
            if (int dimension = source ? dimension_of(source->output) : 0) return dimension;
        }
    }
    return 0;
}

void assign_input(Node& node, std::string_view socket, NodeId source)
{
    auto place = input_place(node, socket);
    bool wired = place != node.inputs.end() && place->first == socket;
    if (wired && source) place->second = source;
    else if (wired) node.inputs.erase(place);
    else if (source) node.inputs.emplace(place, std::string(socket), source);
}

// What speaks against wires that the graph has already; the others are known to be good.
Refusal new_wires_error(const Document& document, const Library& library, const std::vector<Wire>& wires)
{
    if (wire_count(document.root) > wire_limit) return "a scene has at most " + std::to_string(wire_limit) + " wires";
    std::set<std::pair<NodeId, std::string_view>> fresh;
    for (const Wire& wire : wires) fresh.emplace(wire.target, wire.socket);
    WireRules rules(document.root, library);
    for (const Node& node : document.root.nodes)
        for (const auto& [socket, source] : node.inputs)
            if (!fresh.contains({node.id, socket})) rules.add(source, node.id, socket);
    for (const auto& [target, socket] : fresh)
        if (NodeId source = document.root.find(target)->input(socket))
            if (Refusal refusal = rules.add(source, target, socket)) return refusal;
    if (!find_cycle(document.root).empty()) return "these wires would make a cycle: nothing can be made of itself";
    return std::nullopt;
}

}  // namespace

Refusal node_name_error(std::string_view name)
{
    if (name.size() > name_limit) return "a node's name has at most 256 bytes; shorten it";
    if (!is_utf8(name)) return "a node's name must be UTF-8 text";
    return std::nullopt;
}

NodeId add_node(Document& document, const Library& library, std::string_view type_name, glm::vec2 position)
{
    const NodeType* type = library.type(type_name);
    if (!type || node_count(document) >= node_limit || !is_finite(position)) return {};
    Node node;
    node.id = {document.next_id++};
    node.type = type->name;
    node.position = position;
    for (const Parameter& parameter : type->parameters)
        if (parameter.kind != ParameterKind::material) node.parameters.emplace_back(parameter.name, parameter.initial);
    document.root.nodes.push_back(std::move(node));
    return document.root.nodes.back().id;
}

Refusal remove_node(Document& document, NodeId id)
{
    const Node* removed = document.root.find(id);
    if (!removed) return no_node(id);
    document.root.nodes.erase(document.root.nodes.begin() + (removed - document.root.nodes.data()));
    for (Node& node : document.root.nodes)
        std::erase_if(node.inputs, [id](const auto& input) { return input.second == id; });
    return std::nullopt;
}

Refusal remove_nodes(Document& document, const std::set<NodeId>& nodes)
{
    for (NodeId id : nodes)
        if (!document.root.find(id)) return no_node(id);
    std::erase_if(document.root.nodes, [&](const Node& node) { return nodes.contains(node.id); });
    for (Node& node : document.root.nodes)
        std::erase_if(node.inputs, [&](const auto& input) { return nodes.contains(input.second); });
    return std::nullopt;
}

Refusal connect(Document& document, const Library& library, NodeId source, NodeId target, std::string_view socket)
{
    Refusal refusal;
    Node* node = editable(document, target, refusal);
    if (!node) return refusal;
    if ((refusal = wire_error(document, library, source, target, socket))) return refusal;
    if (wire_count(document.root) >= wire_limit) return "a scene has at most " + std::to_string(wire_limit) + " wires";
    if (reaches(document.root, source, target))
        return titled(title_of(*document.root.find(source), library)) + " is made of " +
               titled(title_of(*node, library)) + " itself; this wire would make a cycle";
    assign_input(*node, socket, source);
    return std::nullopt;
}

Refusal connect_all(Document& document, const Library& library, const std::vector<Wire>& wires)
{
    std::map<NodeId, std::vector<std::pair<std::string, NodeId>>> before;
    for (const Wire& wire : wires) {
        Refusal refusal;
        const Node* target = editable(document, wire.target, refusal);
        if (!target) return refusal;
        if (wire.source && !document.root.find(wire.source)) return no_node(wire.source);
        before.emplace(target->id, target->inputs);
    }
    for (const Wire& wire : wires) assign_input(*document.root.find(wire.target), wire.socket, wire.source);
    Refusal refusal = new_wires_error(document, library, wires);
    if (refusal)
        for (auto& [id, inputs] : before) document.root.find(id)->inputs = std::move(inputs);
    return refusal;
}

Refusal disconnect(Document& document, NodeId target, std::string_view socket)
{
    Refusal refusal;
    Node* node = editable(document, target, refusal);
    if (!node) return refusal;
    auto place = input_place(*node, socket);
    if (place == node->inputs.end() || place->first != socket)
        return "nothing is wired to " + in_quotes(socket) + " of " + titled(node_title(*node, nullptr));
    node->inputs.erase(place);
    return std::nullopt;
}

Refusal set_parameter(Document& document, const Library& library, NodeId id, std::string_view name, Value value)
{
    Refusal refusal;
    Node* node = editable(document, id, refusal);
    if (!node) return refusal;
    const NodeType* type = library.type(node->type);
    if (!type) return titled(title_of(*node, library)) + " is of a type this version does not know";
    const Parameter* parameter = type->parameter(name);
    if (!parameter)
        return titled(node_title(*node, type)) + " has no parameter " + in_quotes(name) + "; its parameters are " +
               parameter_names(*type);
    if (std::string error = value_error(*parameter, value); !error.empty())
        return titled(socket_label(type, name)) + " of " + titled(node_title(*node, type)) + " " + error;
    for (auto& [key, current] : node->parameters)
        if (key == name) current = std::move(value);
    return std::nullopt;
}

Refusal rename_node(Document& document, NodeId id, std::string_view name)
{
    Refusal refusal;
    Node* node = editable(document, id, refusal);
    if (!node) return refusal;
    if ((refusal = node_name_error(name))) return refusal;
    node->name = name;
    return std::nullopt;
}

Refusal move_node(Document& document, NodeId id, glm::vec2 position)
{
    Refusal refusal;
    Node* node = editable(document, id, refusal);
    if (!node) return refusal;
    if (!is_finite(position)) return "a node's position must be finite";
    node->position = position;
    return std::nullopt;
}

Refusal set_muted(Document& document, NodeId id, bool muted)
{
    Refusal refusal;
    Node* node = editable(document, id, refusal);
    if (node) node->muted = muted;
    return refusal;
}

namespace {

template <typename Settings>
Refusal replace_settings(Settings& kept, const Settings& settings)
{
    Refusal refusal = setting_refusal(setting_error(settings));
    if (!refusal) kept = settings;
    return refusal;
}

}  // namespace

Refusal set_march(Document& document, const MarchSettings& settings)
{
    return replace_settings(document.march, settings);
}

Refusal set_occlusion(Document& document, const OcclusionSettings& settings)
{
    return replace_settings(document.occlusion, settings);
}

Refusal set_picture(Document& document, const PictureSettings& settings)
{
    return replace_settings(document.picture, settings);
}

Refusal set_animation(Document& document, const AnimationSettings& settings)
{
    return replace_settings(document.animation, settings);
}

Refusal set_fog(Document& document, const FogSettings& settings) { return replace_settings(document.fog, settings); }

Refusal set_bounces(Document& document, int bounces)
{
    if (Refusal refusal = setting_refusal(bounces_error(bounces))) return refusal;
    document.bounces = bounces;
    return std::nullopt;
}

Refusal wire_error(const Document& document, const Library& library, NodeId source, NodeId target,
                   std::string_view socket)
{
    const Node* from = document.root.find(source);
    const Node* to = document.root.find(target);
    if (!from) return no_node(source);
    if (!to) return no_node(target);
    const NodeType* source_type = library.type(from->type);
    const NodeType* target_type = library.type(to->type);
    if (Refusal refusal = kind_error({from, source_type}, {to, target_type}, socket)) return refusal;
    if (!source_type || !target_type || !source_type->is_field()) return std::nullopt;
    // The wire to be replaced must not speak for the dimension of its target.
    if (to->input(socket)) {
        WireRules rules(document.root, library);
        rules.add_all(target, socket);
        return rules.add(source, target, socket);
    }
    int taken = dimension_of(target_type->input(socket)->kind);
    return dimension_error({from, source_type}, field_dimension(document, library, source), {to, target_type},
                           taken ? taken : field_dimension(document, library, target), socket);
}

int field_dimension(const Document& document, const Library& library, NodeId id)
{
    const Node* node = document.root.find(id);
    if (!node) return 0;
    if (int dimension = upstream_dimension(document.root, library, id)) return dimension;
    if (node->inputs.empty() && !feeds_something(document.root, id)) return 0;
    WireRules rules(document.root, library);
    rules.add_all();
    return rules.dimension(id);
}

}  // namespace fieldwright::graph
