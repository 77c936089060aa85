// The commands of the command line: each adds itself to the parser and, when chosen, becomes the session's action.
#pragma once

#include "app/user_nodes.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace fieldwright::app {

struct Session {
    std::filesystem::path shaders;  // --shaders: a folder instead of the library built in; empty = built in
    std::function<int()> action;    // of the chosen command; returns the exit code

    // With the nodes of the user's folder.
    std::shared_ptr<const graph::Library> library() const { return user_library(shaders); }
};

// Opens the window on a scene, or on a new one when the path is empty; the exit code.
int edit(const std::filesystem::path& scene, const Session& session);

void add_edit(CLI::App& parser, Session& session);
void add_render(CLI::App& parser, Session& session);
void add_slice(CLI::App& parser, Session& session);
void add_eval(CLI::App& parser, Session& session);
void add_check(CLI::App& parser, Session& session);
void add_export(CLI::App& parser, Session& session);
void add_nodes(CLI::App& parser, Session& session);
void add_new(CLI::App& parser, Session& session);
void add_info(CLI::App& parser, Session& session);

void print_version(bool json);

}  // namespace fieldwright::app
