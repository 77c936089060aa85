// `nodes`: every node type of the library, as a table or as JSON.
#include "app/commands.h"
#include "app/node_pages.h"

#include <charconv>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

namespace fieldwright::app {
namespace {

using Json = nlohmann::ordered_json;
using graph::NodeType;

const char* quality_name(graph::Quality quality)
{
    switch (quality) {
        case graph::Quality::exact: return "exact";
        case graph::Quality::bound: return "bound";
        case graph::Quality::approximate: break;
    }
    return "approximate";
}

// The float's shortest decimal, so that 0.1f prints as 0.1.
Json number_json(float number)
{
    char digits[32];
    auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    double shortest = 0;
    std::from_chars(digits, end, shortest);
    return shortest;
}

struct ValueJson {
    Json operator()(bool value) const { return value; }
    Json operator()(int value) const { return value; }
    Json operator()(float value) const { return number_json(value); }
    Json operator()(const std::string& value) const { return value; }
    Json operator()(const graph::PointList& points) const
    {
        Json list = Json::array();
        for (const glm::vec4& point : points) list.push_back(components(point));
        return list;
    }
    template <glm::length_t Size>
    Json operator()(const glm::vec<Size, float>& vector) const
    {
        return components(vector);
    }
    template <typename Vector>
    static Json components(const Vector& vector)
    {
        Json list = Json::array();
        for (glm::length_t i = 0; i < vector.length(); ++i) list.push_back(number_json(vector[i]));
        return list;
    }
};

Json parameter_json(const graph::Parameter& parameter)
{
    Json json = {{"name", parameter.name}, {"kind", graph::parameter_kind_name(parameter.kind)}};
    if (parameter.kind != graph::ParameterKind::material) json["default"] = std::visit(ValueJson(), parameter.initial);
    if (graph::has_range(parameter.kind)) {
        json["minimum"] = parameter.minimum;
        json["maximum"] = parameter.maximum;
        json["soft_minimum"] = parameter.soft_minimum;
        json["soft_maximum"] = parameter.soft_maximum;
    }
    json["unit"] = parameter.unit;
    json["help"] = parameter.help;
    if (!parameter.choices.empty()) json["choices"] = parameter.choices;
    return json;
}

Json type_json(const NodeType& type)
{
    Json json = {{"name", type.name}, {"category", type.category}, {"title", type.title}, {"help", type.help}};
    if (type.is_field())
        json["field"] = {{"outside", quality_name(type.quality_outside)},
                         {"inside", quality_name(type.quality_inside)}};
    json["synonyms"] = type.synonyms;
    json["inputs"] = Json::array();
    for (const graph::Socket& socket : type.inputs)
        json["inputs"].push_back({{"name", socket.name}, {"kind", graph::socket_kind_name(socket.kind)}});
    json["output"] = graph::socket_kind_name(type.output);
    json["parameters"] = Json::array();
    for (const graph::Parameter& parameter : type.parameters) json["parameters"].push_back(parameter_json(parameter));
    json["compiled"] = type.compiled;
    json["thumbnail"] = node_page_stem(type) + ".png";  // in the folder of `--pages`
    return json;
}

void print_json(const graph::Library& library)
{
    Json list = Json::array();
    for (const NodeType* type : library.types()) list.push_back(type_json(*type));
    std::cout << list.dump(2) << "\n";
}

void print_table(const graph::Library& library)
{
    std::string category;
    for (const NodeType* type : library.types()) {
        if (type->category != category) std::cout << (category.empty() ? "" : "\n") << type->category << "\n";
        category = type->category;
        std::cout << "  " << std::left << std::setw(22) << type->name << " " << type->help << "\n";
    }
}

}  // namespace

void add_nodes(CLI::App& parser, Session& session)
{
    struct Arguments {
        bool json = false;
        std::filesystem::path pages;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App& command = *parser.add_subcommand("nodes", "List every node type");
    CLI::Option* json = command.add_flag("--json", arguments->json, "Print JSON: sockets, parameters, ranges, help");
    command.add_option("--pages", arguments->pages, "Write a page and a thumbnail of every type into a folder instead")
        ->excludes(json);
    command.callback([arguments, &session] {
        session.action = [arguments, &session] {
            auto library = session.library();
            if (!arguments->pages.empty()) write_node_pages(library, arguments->pages);
            else (arguments->json ? print_json : print_table)(*library);
            return 0;
        };
    });
}

}  // namespace fieldwright::app
