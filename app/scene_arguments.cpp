// Reads the scene that a command names and makes the changes of `--set`.
#include "app/scene_arguments.h"

#include "app/baking.h"
#include "app/picture_shelf.h"
#include "graph/group_types.h"
#include "graph/own_type_edits.h"
#include "graph/own_types.h"
#include "graph/scene_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>

namespace fieldwright::app {
namespace {

using graph::Document;
using graph::Failure;
using graph::Library;
using graph::Node;
using graph::NodeId;

std::string finite_number(const std::string& text)
{
    float number = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(number) ? "" : "`" + text + "` is not a finite number";
}

template <typename Matches>
std::vector<const Node*> nodes_where(const Document& document, Matches matches)
{
    std::vector<const Node*> found;
    for (const Node& node : document.root.nodes)
        if (matches(node)) found.push_back(&node);
    return found;
}

// The node meant by an id, a name or, where nothing has that name, a type.
NodeId find_node(const Document& document, const std::string& word)
{
    std::int64_t number = 0;
    auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc() && end == word.data() + word.size()) {
        if (document.root.find(NodeId{number})) return NodeId{number};
        throw Failure(2, "--set: the scene has no node " + word + "; `fieldwright check` lists what it has");
    }
    std::vector<const Node*> found = nodes_where(document, [&](const Node& node) { return node.name == word; });
    if (found.empty()) found = nodes_where(document, [&](const Node& node) { return node.type == word; });
    if (found.empty())
        throw Failure(2, "--set: the scene has no node named `" + word + "`; use a node's name or its id");
    if (found.size() == 1) return found.front()->id;
    std::string ids;
    for (const Node* node : found) ids += (ids.empty() ? "" : ", ") + std::to_string(node->id.number);
    throw Failure(2, "--set: `" + word + "` means several nodes (" + ids + "); use one of these ids instead");
}

// node.parameter=value; a node's name may hold dots, a parameter's cannot.
void make_change(Document& document, const Library& library, const std::string& change)
{
    auto [target, value] = split_assignment(change);
    std::size_t dot = target.rfind('.');
    if (dot == std::string::npos || dot == 0)
        throw Failure(2, "--set: `" + change + "` names no node; write node.parameter=value");
    NodeId node = find_node(document, target.substr(0, dot));
    set_from_text(document, library, node, target.substr(dot + 1), value);
}

std::string parameter_names(const graph::NodeType& type)
{
    std::string names;
    for (const graph::Parameter& parameter : type.parameters)
        if (parameter.kind != graph::ParameterKind::material) names += (names.empty() ? "" : ", ") + parameter.name;
    return names.empty() ? "it has none" : "it has " + names;
}

}  // namespace

void add_scene(CLI::App& command, SceneArguments& arguments)
{
    command.add_option("scene", arguments.path, "Scene file (*.scene.json)")->required();
}

void add_changes(CLI::App& command, SceneArguments& arguments)
{
    command
        .add_option("--set", arguments.changes,
                    "Change a parameter: node.parameter=value, where node is an id or a unique name; angles in degrees")
        ->allow_extra_args(false);
}

void add_time(CLI::App& command, SceneArguments& arguments)
{
    command.add_option("--time", arguments.time, "Moment to show, in seconds")->check(finite_number)->default_str("0");
}

void add_allow_code(CLI::App& command, SceneArguments& arguments)
{
    command.add_flag("--allow-code", arguments.allow_code,
                     "Run the shader code that a scene brings with it; only for scenes that you trust");
}

OpenedScene open_document(const SceneArguments& arguments, const std::shared_ptr<const Library>& base)
{
    Document document = graph::open_scene(arguments.path, *base);
    std::shared_ptr<const Library> library = graph::library_for(base, document.own_types);
    if (!document.groups.empty()) library = graph::with_groups(*library, document);
    Baking baking;
    baking.follow(document, *library);
    for (const std::string& change : arguments.changes) make_change(document, *library, change);
    baking.bake(document, *library);
    return {std::move(document), std::move(library)};
}

void require_allowed_code(const SceneArguments& arguments, const Document& document)
{
    auto used = std::count_if(document.own_types.begin(), document.own_types.end(), [&](const graph::OwnType& type) {
        return graph::uses_of_own_type(document, type.name) > 0;
    });
    if (arguments.allow_code || used == 0) return;
    throw Failure(3, arguments.path.string() + ": brings its own shader code (" + std::to_string(used) +
                         (used == 1 ? " node type" : " node types") +
                         "), which runs only when you allow it; add --allow-code if you trust the scene");
}

graph::Program lower_scene(const SceneArguments& arguments, const Document& document,
                           const std::shared_ptr<const Library>& library, graph::LowerOptions options)
{
    graph::BakedImages images = images_of(document, *library, arguments.path.parent_path());
    options.images = &images;
    return graph::lower(document, library, options);
}

void set_from_text(Document& document, const Library& library, NodeId id, std::string_view name, std::string_view text)
{
    const Node& node = *document.root.find(id);
    const graph::NodeType* type = library.type(node.type);
    std::string what = "--set: " + node_label(document, id);
    if (!type) throw Failure(2, what + " is of the unknown type `" + node.type + "` and cannot be changed");
    const graph::Parameter* parameter = type->parameter(name);
    if (!parameter || parameter->kind == graph::ParameterKind::material)
        throw Failure(2, what + " has no parameter `" + std::string(name) + "`; " + parameter_names(*type));
    std::optional<graph::Value> value = graph::parse_value(*parameter, text);
    if (!value)
        throw Failure(2, what + ": `" + std::string(text) + "` does not read as the " +
                             std::string(graph::parameter_kind_name(parameter->kind)) + " `" + parameter->name + "`");
    if (std::string error = graph::value_error(*parameter, *value); !error.empty())
        throw Failure(2, what + ": `" + parameter->name + "` " + error);
    if (node.input(name))
        std::cerr << "warning: " << node_label(document, id) << ": `" << name
                  << "` is wired, so the value after --set does not show\n";
    if (graph::Refusal refusal = graph::set_parameter(document, library, id, name, *value))
        throw Failure(2, what + ": " + *refusal);
}

std::pair<std::string, std::string> split_assignment(const std::string& text)
{
    std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw Failure(2, "--set: `" + text + "` has no value; write name=value");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::string node_label(const Document& document, NodeId id)
{
    const Node* node = document.root.find(id);
    std::string label = "node " + std::to_string(id.number);
    if (!node) return id ? label : "scene";
    return label + " \"" + (node->name.empty() ? node->type : node->name) + "\"";
}

std::vector<graph::Problem> problems_of(const graph::Program& program, const Document& document)
{
    std::vector<graph::Problem> problems = program.problems;
    for (graph::Problem& note : Baking().notes(document, *program.library)) problems.push_back(std::move(note));
    return problems;
}

void report_problems(const graph::Program& program, const Document& document)
{
    for (const graph::Problem& problem : problems_of(program, document))
        std::cerr << "warning: " << node_label(document, problem.node) << ": " << problem.sentence << "\n";
}

void require_place(const std::filesystem::path& path)
{
    std::error_code error;
    std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (!std::filesystem::is_directory(folder, error))
        throw Failure(5, path.string() + ": the folder " + folder.string() + " does not exist; make it first");
    if (std::filesystem::is_directory(path, error))
        throw Failure(5, path.string() + ": is a folder; name a file in it");
}

}  // namespace fieldwright::app
