#include "graph/node_reader.h"

#include "graph/limits.h"
#include "graph/value_reader.h"
#include "graph/wire_rules.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

// Only what can be shown of it; the text is the node.
void read_placeholder(const SceneJson& json, const JsonValue& value, Node& node)
{
    node.unknown_source = json.source(value);
    const JsonValue* name = json.member(value, "name");
    if (name && name->kind == JsonKind::string && name->string.size() <= name_limit) node.name = name->string;
    const JsonValue* muted = json.member(value, "muted");
    if (muted && muted->kind == JsonKind::boolean) node.muted = muted->truth;
    const JsonValue* position = json.member(value, "position");
    if (!position || position->kind != JsonKind::array || position->count != 2) return;
    const JsonValue* x = json.first_child(*position);
    const JsonValue* y = json.next_sibling(*x);
    if (x->kind == JsonKind::number && y->kind == JsonKind::number) node.position = {json.number(*x), json.number(*y)};
}

void read_parameters(const SceneJson& json, const JsonValue* object, const NodeType& type, Node& node)
{
    node.parameters.reserve(type.parameters.size());
    for (const Parameter& parameter : type.parameters)
        if (parameter.kind != ParameterKind::material)
            node.parameters.emplace_back(parameter.name, parameter.older.value_or(parameter.initial));
    if (!object) return;
    for (const JsonValue* member = json.first_child(*object); member; member = json.next_sibling(*member)) {
        const Parameter* parameter = type.parameter(member->key);
        if (!parameter)
            json.fail_at_key(*member,
                             "is not a parameter of `" + type.name + "`; its parameters are " + parameter_names(type));
        if (parameter->kind == ParameterKind::material)
            json.fail_at_key(*member, "is a socket without a value; wire a material to it under `inputs`");
        auto place = std::find_if(node.parameters.begin(), node.parameters.end(),
                                  [&](const auto& known) { return known.first == parameter->name; });
        place->second = read_value(json, *member, *parameter);
    }
}

}  // namespace

const JsonValue* read_node(const SceneJson& json, const JsonValue& value, const Library& library, Node& node)
{
    node.type = json.short_text(json.required(value, "type", "e.g. \"type\": \"sphere\""));
    const NodeType* type = library.type(node.type);
    if (!type) {
        read_placeholder(json, value, node);
        return nullptr;
    }
    const JsonValue *parameters = nullptr, *inputs = nullptr;
    for (const JsonValue* member = json.first_child(value); member; member = json.next_sibling(*member)) {
        if (member->key == "type") continue;
        if (member->key == "name") node.name = json.short_text(*member);
        else if (member->key == "position") node.position = json.pair(*member);
        else if (member->key == "muted") node.muted = json.boolean(*member);
        else if (member->key == "parameters") parameters = &json.object(*member);
        else if (member->key == "inputs") inputs = &json.object(*member);
        else json.unknown_member(*member, "`type`, `name`, `position`, `muted`, `parameters`, `inputs`");
    }
    read_parameters(json, parameters, *type, node);
    return inputs;
}

}  // namespace fieldwright::graph
