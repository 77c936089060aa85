#include "graph/value_reader.h"

namespace fieldwright::graph {
namespace {

PointList points(const SceneJson& json, const JsonValue& value)
{
    PointList list;
    list.reserve(json.array(value).count);
    for (const JsonValue* point = json.first_child(value); point; point = json.next_sibling(*point)) {
        if (point->kind != JsonKind::array || point->count < 2 || point->count > 4)
            json.fail(*point, "must be a point of two to four numbers; write e.g. [0.0, 1.0]");
        glm::vec4& target = list.emplace_back(0.0f);
        int i = 0;
        for (const JsonValue* part = json.first_child(*point); part; part = json.next_sibling(*part))
            target[i++] = json.number(*part);
    }
    return list;
}

// A choice that begins with off was a switch in older files: true is the word after it.
std::string choice(const SceneJson& json, const JsonValue& value, const Parameter& parameter)
{
    bool was_switch = parameter.choices.size() > 1 && parameter.choices.front() == "off";
    if (was_switch && value.kind == JsonKind::boolean) return parameter.choices[json.boolean(value) ? 1 : 0];
    return std::string(json.string(value));
}

Value any_value(const SceneJson& json, const JsonValue& value, const Parameter& parameter)
{
    switch (parameter.kind) {
        case ParameterKind::number:
        case ParameterKind::angle: return json.number(value);
        case ParameterKind::integer: return json.small_integer(value);
        case ParameterKind::boolean: return json.boolean(value);
        case ParameterKind::choice: return choice(json, value, parameter);
        case ParameterKind::text:
        case ParameterKind::formula:
        case ParameterKind::image: return std::string(json.string(value));
        case ParameterKind::vec2: return json.pair(value);
        case ParameterKind::vec3:
        case ParameterKind::angles:
        case ParameterKind::colour: return json.triple(value);
        case ParameterKind::list: return points(json, value);
        case ParameterKind::material: break;
    }
    return {};
}

}  // namespace

Value read_value(const SceneJson& json, const JsonValue& value, const Parameter& parameter)
{
    Value result = any_value(json, value, parameter);
    if (std::string error = value_error(parameter, result); !error.empty()) json.fail(value, error);
    return result;
}

}  // namespace fieldwright::graph
