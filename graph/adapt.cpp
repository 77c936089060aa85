// A document under another library: first the nodes, then the wires between them.
#include "graph/adapt.h"

#include "graph/json.h"
#include "graph/problem.h"
#include "graph/scene_file.h"
#include "graph/wire_rules.h"

#include <algorithm>
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

// A value as the scene reader reads it in a scene of one node; nothing when the parameter does not take it.
std::optional<Value> value_from_json(std::string_view json, const Parameter& parameter, const NodeType& type,
                                     const Library& library)
{
    std::string scene = R"({"format": "fieldwright", "version": 1, "graphs": {"root": {"nodes": {"1": {"type": )";
    append_json_string(scene, type.name);
    scene += ", \"parameters\": {";
    append_json_string(scene, parameter.name);
    scene += ": " + std::string(json) + "}}}}}}";
    try {
        Document document = read_scene(scene, library);
        return *document.root.nodes.front().parameter(parameter.name);
    } catch (const Failure&) {
        return std::nullopt;
    }
}

// The placeholder's parameters as its text has them.
Parameters parameters_of_text(const Node& placeholder, const NodeType& type, const Library& library)
{
    Parameters parameters;
    JsonTree tree(placeholder.unknown_source, "node");
    const JsonValue* object = tree.member(tree.root(), "parameters");
    if (!object || object->kind != JsonKind::object) return parameters;
    for (const JsonValue* member = tree.first_child(*object); member; member = tree.next_sibling(*member)) {
        const Parameter* parameter = type.parameter(member->key);
        if (!parameter || parameter->kind == ParameterKind::material) continue;
        if (auto value = value_from_json(tree.source(*member), *parameter, type, library))
            parameters.emplace_back(parameter->name, std::move(*value));
    }
    return parameters;
}

// Nodes of types that are gone become the text that would have been saved.
void keep_as_text(Document& document, const Library& library)
{
    auto is_gone = [&](const Node& node) { return node.unknown_source.empty() && !library.type(node.type); };
    std::vector<Node>& nodes = document.root.nodes;
    if (std::none_of(nodes.begin(), nodes.end(), is_gone)) return;
    std::string scene = write_scene(document, library);
    JsonTree tree(scene, "scene");
    const JsonValue* texts = &tree.root();
    for (const char* key : {"graphs", "root", "nodes"}) texts = tree.member(*texts, key);
    const JsonValue* text = tree.first_child(*texts);  // in the order of the nodes
    for (Node& node : nodes) {
        if (is_gone(node)) {
            node.unknown_source = tree.source(*text);
            node.parameters.clear();
        }
        text = tree.next_sibling(*text);
    }
}

void fit_nodes(Document& document, const Library& library)
{
    for (Node& node : document.root.nodes) {
        const NodeType* type = library.type(node.type);
        if (!type) continue;
        if (!node.unknown_source.empty()) {
            node.parameters = parameters_of_text(node, *type, library);
            node.unknown_source.clear();
        }
        node.parameters = fitted(node, *type);
    }
}

void fit_wires(Document& document, const Library& library)
{
    WireRules rules(document.root, library);
    for (Node& node : document.root.nodes)
        std::erase_if(node.inputs,
                      [&](const auto& input) { return rules.add(input.second, node.id, input.first).has_value(); });
}

}  // namespace

Document adapted(Document document, const Library& library)
{
    keep_as_text(document, library);
    fit_nodes(document, library);
    fit_wires(document, library);
    return document;
}

}  // namespace fieldwright::graph
