// A document under another library: first the nodes, then the wires between them.
#include "graph/adapt.h"

#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/neighbours.h"
#include "graph/problem.h"
#include "graph/scene_file.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fieldwright::graph {
namespace {

using Parameters = std::vector<std::pair<std::string, Value>>;

float clamped(float number, const Parameter& parameter)
{
    return std::clamp(number, static_cast<float>(parameter.minimum), static_cast<float>(parameter.maximum));
}

template <int size>
glm::vec<size, float> clamped(glm::vec<size, float> vector, const Parameter& parameter)
{
    for (int i = 0; i < size; ++i) vector[i] = clamped(vector[i], parameter);
    return vector;
}

int clamped(int number, const Parameter& parameter)
{
    return static_cast<int>(std::clamp<double>(number, std::ceil(parameter.minimum), std::floor(parameter.maximum)));
}

template <typename Other>
Other clamped(Other other, const Parameter&)
{
    return other;
}

// The value as near as the parameter allows it.
Value fitted(const Value& value, const Parameter& parameter)
{
    if (value_error(parameter, value).empty()) return value;
    Value nearest = std::visit([&](const auto& plain) { return Value(clamped(plain, parameter)); }, value);
    return value_error(parameter, nearest).empty() ? nearest : parameter.initial;
}

Parameters fitted(const Node& node, const NodeType& type)
{
    Parameters parameters;
    for (const Parameter& parameter : type.parameters) {
        if (parameter.kind == ParameterKind::material) continue;
        const Value* value = node.parameter(parameter.name);
        parameters.emplace_back(parameter.name, value ? fitted(*value, parameter) : parameter.initial);
    }
    return parameters;
}

// Nothing when the parameter does not take it.
std::optional<Value> value_from_json(std::string_view json, const Parameter& parameter)
{
    try {
        return read_value(json, parameter);
    } catch (const Failure&) {
        return std::nullopt;
    }
}

// The placeholder's parameters as its text has them.
Parameters parameters_of_text(const Node& placeholder, const NodeType& type)
{
    Parameters parameters;
    JsonTree tree(placeholder.unknown_source, "node");
    const JsonValue* object = tree.member(tree.root(), "parameters");
    if (!object || object->kind != JsonKind::object) return parameters;
    for (const JsonValue* member = tree.first_child(*object); member; member = tree.next_sibling(*member)) {
        const Parameter* parameter = type.parameter(member->key);
        if (!parameter || parameter->kind == ParameterKind::material) continue;
        if (auto value = value_from_json(tree.source(*member), *parameter))
            parameters.emplace_back(parameter->name, std::move(*value));
    }
    return parameters;
}

// What of a scene's text a graph is: by the names of its members.
const JsonValue& nodes_in(const JsonTree& tree, std::string_view graph)
{
    const JsonValue* texts = &tree.root();
    for (std::string_view key : {std::string_view("graphs"), graph, std::string_view("nodes")})
        texts = tree.member(*texts, key);
    return *texts;
}

// Nodes of types that are gone become the text that would have been saved.
void keep_as_text(const Document& document, const Library& library, std::string_view name, Graph& graph)
{
    auto is_gone = [&](const Node& node) { return node.unknown_source.empty() && !library.type(node.type); };
    std::vector<Node>& nodes = graph.nodes;
    if (std::none_of(nodes.begin(), nodes.end(), is_gone)) return;
    std::string scene = write_scene(document, library);
    JsonTree tree(scene, "scene");
    const JsonValue* text = tree.first_child(nodes_in(tree, name));  // in the order of the nodes
    for (Node& node : nodes) {
        if (is_gone(node)) {
            node.unknown_source = tree.source(*text);
            node.parameters.clear();
        }
        text = tree.next_sibling(*text);
    }
}

void fit_nodes(Graph& graph, const Library& library)
{
    for (Node& node : graph.nodes) {
        const NodeType* type = library.type(node.type);
        if (!type) continue;
        if (!node.unknown_source.empty()) {
            node.parameters = parameters_of_text(node, *type);
            node.unknown_source.clear();
        }
        node.parameters = fitted(node, *type);
    }
}

void fit_wires(Graph& graph, const Library& library)
{
    WireRules rules(graph, library);
    for (Node& node : graph.nodes)
        std::erase_if(node.inputs,
                      [&](const auto& input) { return rules.add(input.second, node.id, input.first).has_value(); });
}

void fit_graph(const Document& document, const Library& library, std::string_view name, Graph& graph)
{
    keep_as_text(document, library, name, graph);
    fit_nodes(graph, library);
    fit_wires(graph, library);
}

// What a group gives when its output went: of the nodes that nobody in it reads, the one farthest to the right.
NodeId last_unread(const Graph& graph, const Library& library)
{
    const Node* last = nullptr;
    Readers readers(graph);
    for (const Node& node : graph.nodes) {
        if (!readers.of(node.id).empty() || group_output_error(node.id, graph, library)) continue;
        if (!last || node.position.x >= last->position.x) last = &node;
    }
    return last ? last->id : NodeId{};
}

void fit_group(Group& group, const Library& library)
{
    std::erase_if(group.exposed,
                  [&](const Exposed& exposed) { return exposed_error(exposed, group.graph, library).has_value(); });
    if (!group.output || group_output_error(group.output, group.graph, library))
        group.output = last_unread(group.graph, library);
}

}  // namespace

Document adapted(Document document, const Library& library)
{
    assert(document.entered.empty());
    if (document.groups.empty()) {
        fit_graph(document, library, "root", document.root);
        return document;
    }
    std::vector<std::string> order;
    for (const Group* group : inner_first(document)) order.push_back(group->name);
    std::vector<NodeType> types;
    std::shared_ptr<const Library> known = library.with(Origin::group, {});
    for (const std::string& name : order) {
        Group& group = *find_group(document, name);
        fit_graph(document, *known, name, group.graph);
        fit_group(group, *known);
        types.push_back(group_type(group, *known));
        known = library.with(Origin::group, {types, {}});
    }
    fit_graph(document, *known, "root", document.root);
    return document;
}

}  // namespace fieldwright::graph
