// Words for what stands on a node.
#include "ui/node_words.h"

#include <algorithm>
#include <cstdio>

namespace fieldwright::ui {

using graph::Quality;

namespace {

std::string number_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value == 0 ? 0.0 : value);  // no minus before a zero
    return text;
}

template <typename Vector>
std::string vector_text(const Vector& value)
{
    std::string text;
    for (int i = 0; i < Vector::length(); ++i) text += (i ? ", " : "") + number_text(value[i]);
    return text;
}

std::string with_unit(std::string text, const std::string& unit)
{
    if (unit.empty()) return text;
    return text + (unit == "deg" ? "°" : " " + unit);
}

const char* quality_word(Quality quality)
{
    return quality == Quality::exact ? "exact" : quality == Quality::bound ? "a bound" : "approximate";
}

std::string kind_hint(graph::SocketKind kind)
{
    return kind == graph::SocketKind::none ? "of a type this program does not know"
                                           : std::string(graph::kind_words(kind));
}

}  // namespace

std::string node_hint(const graph::Node& node, const graph::NodeType* type)
{
    if (!type)
        return node_title(node, type) + "\nThis program does not know the type " + graph::titled(node.type) + ".";
    std::string title = node.name.empty() ? type->title : node.name + " (" + type->title + ")";
    return title + "\n" + type->help;
}

std::string socket_hint(const graph::NodeType* type, std::string_view socket)
{
    const graph::Socket* found = type ? type->input(socket) : nullptr;
    std::string hint = socket_label(type, socket) + ": " + kind_hint(found ? found->kind : graph::SocketKind::none);
    const graph::Parameter* parameter = type ? type->parameter(socket) : nullptr;
    if (parameter && !parameter->unit.empty())
        hint += parameter->unit == "deg" ? ", in degrees" : ", in " + parameter->unit;
    if (parameter && !parameter->help.empty()) hint += "\n" + parameter->help;
    return hint;
}

std::string output_hint(const graph::NodeType* type)
{
    return std::string("Gives: ") + kind_hint(type ? type->output : graph::SocketKind::none);
}

std::string value_text(const graph::Parameter& parameter, const graph::Value& value)
{
    if (const float* number = std::get_if<float>(&value)) return with_unit(number_text(*number), parameter.unit);
    if (const int* number = std::get_if<int>(&value)) return with_unit(std::to_string(*number), parameter.unit);
    if (parameter.kind == graph::ParameterKind::colour) return {};
    if (const auto* two = std::get_if<glm::vec2>(&value)) return vector_text(*two);
    if (const auto* three = std::get_if<glm::vec3>(&value)) return vector_text(*three);
    return {};
}

QualityWords quality_words(const graph::NodeType& type)
{
    Quality worse = std::max(type.quality_outside, type.quality_inside);
    const char* sign = worse == Quality::exact ? "=" : worse == Quality::bound ? "\xe2\x89\xa4" : "\xe2\x89\x88";
    std::string outside = quality_word(type.quality_outside), inside = quality_word(type.quality_inside);
    std::string sentence = outside == inside ? "Its distance is " + outside + "."
                                             : "Its distance is " + outside + " outside and " + inside + " inside.";
    if (worse == Quality::exact) sentence += " Rays take the longest steps.";
    if (worse == Quality::bound) sentence += " It is never more than the true one, so rays may take more steps.";
    if (worse == Quality::approximate) sentence += " Rays take shorter steps, so that they miss nothing.";
    return {sign, sentence};
}

}  // namespace fieldwright::ui
