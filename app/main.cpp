// Parses the command line, runs the chosen command and turns every error into one sentence and an exit code.
#include "app/commands.h"
#include "app/worker_jobs.h"
#include "graph/problem.h"

#include <iostream>

namespace {

using namespace fieldwright;

constexpr int usage_error = 2;
constexpr int shader_error = 6;

int complain(const std::string& sentence, int code)
{
    std::cerr << "fieldwright: " << sentence << "\n";
    return code;
}

// Words that no command took: a scene alone opens the window, anything else is a slip.
int take_words(const CLI::App& parser, const app::Session& session, const std::vector<std::string>& words)
{
    const std::string& first = words.front();
    bool chosen = !parser.get_subcommands().empty();
    std::error_code error;
    bool is_scene = first.ends_with(".scene.json") || std::filesystem::exists(first, error);
    if (!chosen && is_scene && words.size() == 1) return app::edit(first, session);
    if (first.starts_with("-") || chosen || is_scene)
        return complain("the argument `" + words.back() + "` was not expected; see `fieldwright --help`", usage_error);
    std::string names;
    for (const CLI::App* command : parser.get_subcommands({}))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return complain("`" + first + "` is neither a command nor a scene file; the commands are " + names, usage_error);
}

int run(int argc, char** argv)
{
    app::Session session;
    bool version = false, json = false;
    CLI::App parser("Fieldwright: node graphs of signed distance fields, drawn by sphere tracing.", "fieldwright");
    parser.add_flag("--version", version, "Print the version and stop");
    parser.add_flag("--json", json, "With --version: as JSON");
    for (auto add : {app::add_edit, app::add_render, app::add_slice, app::add_eval, app::add_check, app::add_export,
                     app::add_nodes, app::add_new, app::add_info})
        add(parser, session);
    constexpr auto shaders_help = "Read node files and shading from this folder instead of those built in";
    parser.add_option("--shaders", session.shaders, shaders_help);
    for (CLI::App* command : parser.get_subcommands({}))
        command->add_option("--shaders", session.shaders, shaders_help);
    parser.allow_extras();
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return parser.exit(error);
        return complain(std::string(error.what()) + "; see `fieldwright --help`", usage_error);
    }
    if (std::vector<std::string> words = parser.remaining(); !words.empty()) return take_words(parser, session, words);
    if (session.action) return session.action();
    if (version) {
        app::print_version(json);
        return 0;
    }
    return app::edit({}, session);
}

}  // namespace

int main(int argc, char** argv)
{
    if (app::is_worker({argv, static_cast<std::size_t>(argc)}))
        return app::work({argv, static_cast<std::size_t>(argc)});
    std::ios::sync_with_stdio(false);
    try {
        int code = run(argc, argv);
        if (!std::cout.flush()) return complain("the standard output cannot be written; check the disk or the pipe", 5);
        return code;
    } catch (const graph::Failure& failure) {
        return complain(failure.what(), failure.exit_code);
    } catch (const graph::DialectError& error) {
        return complain(error.what(), shader_error);
    } catch (const std::bad_alloc&) {
        return complain("out of memory; use a smaller picture or scene", 1);
    } catch (const std::exception& error) {
        return complain(error.what(), 1);
    }
}
