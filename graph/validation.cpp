// What every document promises, looked at as a whole.
#include "graph/edits.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/settings.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::graph {
namespace {

// Parameters of a known type: all there, in order, in range.
Refusal parameters_error(const Node& node, const NodeType& type)
{
    std::size_t count = 0;
    for (const Parameter& parameter : type.parameters) {
        if (parameter.kind == ParameterKind::material) continue;
        if (count == node.parameters.size() || node.parameters[count].first != parameter.name)
            return described(node) + " lacks its parameter `" + parameter.name + "`";
        std::string error = value_error(parameter, node.parameters[count++].second);
        if (!error.empty()) return "`" + parameter.name + "` of " + described(node) + " " + error;
    }
    if (count != node.parameters.size()) return described(node) + " has a parameter too many";
    return std::nullopt;
}

Refusal node_error(const Document& document, const Library& library, const Node& node)
{
    if (node.id.number < 1 || node.id.number >= document.next_id)
        return described(node) + " has an id outside 1 .. next_id - 1";
    if (Refusal error = node_name_error(node.name)) return described(node) + ": " + *error;
    if (!std::isfinite(node.position.x) || !std::isfinite(node.position.y))
        return described(node) + " has a position that is not finite";
    auto not_before = [](const auto& a, const auto& b) { return a.first >= b.first; };
    if (std::adjacent_find(node.inputs.begin(), node.inputs.end(), not_before) != node.inputs.end())
        return described(node) + " has inputs that are not sorted by name";
    const NodeType* type = library.type(node.type);
    if (!type) return node.unknown_source.empty() ? Refusal(described(node) + " is of an unknown type") : std::nullopt;
    if (!node.unknown_source.empty()) return described(node) + " is of a known type but kept as text";
    return parameters_error(node, *type);
}

Refusal graph_error(const Document& document, const Library& library, const Graph& graph)
{
    auto unordered = [](const Node& a, const Node& b) { return a.id >= b.id; };
    if (std::adjacent_find(graph.nodes.begin(), graph.nodes.end(), unordered) != graph.nodes.end())
        return "the nodes are not sorted by id, each once";
    for (const Node& node : graph.nodes)
        if (Refusal refusal = node_error(document, library, node)) return refusal;
    if (Refusal refusal = WireRules(graph, library, Wording::file).add_all()) return refusal;
    if (std::vector<NodeId> cycle = find_cycle(graph); !cycle.empty())
        return "the wires " + cycle_text(cycle) + " make a cycle; remove one of them";
    return std::nullopt;
}

}  // namespace

Refusal validate(const Document& document, const Library& library)
{
    if (Refusal refusal = setting_refusal(setting_error(document.march))) return refusal;
    if (Refusal refusal = setting_refusal(setting_error(document.occlusion))) return refusal;
    if (Refusal refusal = setting_refusal(setting_error(document.picture))) return refusal;
    if (Refusal refusal = setting_refusal(setting_error(document.animation))) return refusal;
    if (Refusal refusal = setting_refusal(setting_error(document.fog))) return refusal;
    if (Refusal refusal = setting_refusal(bounces_error(document.bounces))) return refusal;
    auto names_unordered = [](const OwnType& a, const OwnType& b) { return a.name >= b.name; };
    const std::vector<OwnType>& types = document.own_types;
    if (std::adjacent_find(types.begin(), types.end(), names_unordered) != types.end())
        return "the own types are not sorted by name, each once";
    if (document.groups.empty()) return graph_error(document, library, document.root);
    std::shared_ptr<const Library> own = with_groups(library, document);
    if (Refusal refusal = groups_error(document, *own)) return refusal;
    for (const Group& group : document.groups)
        if (Refusal refusal = graph_error(document, *own, group.graph))
            return "group " + in_quotes(group.name) + ": " + *refusal;
    return graph_error(document, *own, document.root);
}

}  // namespace fieldwright::graph
