// What the commands that read a scene take in common: the file, changed parameters, a moment in time.
#pragma once

#include "graph/program.h"

#include <CLI/CLI.hpp>

namespace fieldwright::app {

struct SceneArguments {
    std::filesystem::path path;
    std::vector<std::string> changes;  // node.parameter=value, in the order given
    float time = 0;                    // s
    bool allow_code = false;           // runs the shader code that the scene brings
};

struct OpenedScene {
    graph::Document document;
    std::shared_ptr<const graph::Library> library;  // knows the document's own types
};

void add_scene(CLI::App& command, SceneArguments& arguments);
void add_changes(CLI::App& command, SceneArguments& arguments);
void add_time(CLI::App& command, SceneArguments& arguments);
void add_allow_code(CLI::App& command, SceneArguments& arguments);

// Reads the file and makes the changes. Failure 3 for the file, 2 for a change.
OpenedScene open_document(const SceneArguments& arguments, const std::shared_ptr<const graph::Library>& library);
// Failure 3 when the scene has node types of its own that its nodes use and that are not allowed.
void require_allowed_code(const SceneArguments& arguments, const graph::Document& document);
// The program of it, with its pictures read.
graph::Program lower_scene(const SceneArguments& arguments, const graph::Document& document,
                           const std::shared_ptr<const graph::Library>& library, graph::LowerOptions options = {});
// Parses `text` for the parameter and sets it. Failure 2 with the reason when it does not fit.
void set_from_text(graph::Document& document, const graph::Library& library, graph::NodeId node,
                   std::string_view parameter, std::string_view text);
// `name=value` at its first `=`. Failure 2 when there is none.
std::pair<std::string, std::string> split_assignment(const std::string& text);

std::string node_label(const graph::Document& document, graph::NodeId node);  // node 5 "Name"
// The program's, and those of what the document holds ready-made.
std::vector<graph::Problem> problems_of(const graph::Program& program, const graph::Document& document);
// They as `warning: node 5 "Name": sentence` lines on stderr.
void report_problems(const graph::Program& program, const graph::Document& document);

// Failure 5 unless a file can be put at `path`: its folder exists and it is not a folder itself.
void require_place(const std::filesystem::path& path);

}  // namespace fieldwright::app
