// `check`: whether a scene file is valid, its problems and what it costs.
#include "app/commands.h"
#include "app/scene_arguments.h"
#include "app/silhouettes.h"
#include "graph/problem.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace fieldwright::app {
namespace {

using Json = nlohmann::ordered_json;

bool is_error(const graph::Problem& problem) { return problem.severity == graph::Problem::Severity::error; }

Json problem_json(const graph::Problem& problem)
{
    return {{"node", problem.node ? Json(problem.node.number) : Json()},
            {"sentence", problem.sentence},
            {"severity", is_error(problem) ? "error" : "note"}};
}

void print_json(const graph::Document& document, const graph::Program& program, bool valid)
{
    Json problems = Json::array();
    for (const graph::Problem& problem : problems_of(program, document)) problems.push_back(problem_json(problem));
    std::cout << Json{{"valid", valid},
                      {"problems", problems},
                      {"nodes", document.root.nodes.size()},
                      {"cost", program.expanded_cost},
                      {"step_budget", program.step_budget}}
                     .dump(2)
              << "\n";
}

void print_lines(const std::filesystem::path& path, const graph::Document& document, const graph::Program& program,
                 bool valid)
{
    for (const graph::Problem& problem : problems_of(program, document))
        std::cout << (is_error(problem) ? "error: " : "note: ") << node_label(document, problem.node) << ": "
                  << problem.sentence << "\n";
    std::cout << path.string() << ": " << (valid ? "valid" : "has problems") << ", " << document.root.nodes.size()
              << " nodes, cost " << program.expanded_cost << ", step budget " << program.step_budget << "\n";
}

// A file that cannot be read into a document, for readers of JSON; the sentence goes to stderr as always.
void print_refusal(const std::string& sentence)
{
    std::cout << Json{{"valid", false}, {"problems", {problem_json({{}, sentence})}}}.dump(
                     2, ' ', false, Json::error_handler_t::replace)
              << "\n";
}

int check(const SceneArguments& arguments, bool json, const Session& session)
{
    try {
        auto [document, library] = open_document(arguments, session.library());
        graph::Program program = lower_scene(arguments, document, library);
        for (graph::Problem& note : compare_silhouettes(document, library, false).notes)
            program.problems.push_back(std::move(note));
        bool valid = std::none_of(program.problems.begin(), program.problems.end(), is_error);
        if (json) print_json(document, program, valid);
        else print_lines(arguments.path, document, program, valid);
        return valid ? 0 : 3;
    } catch (const graph::Failure& failure) {
        if (json && failure.exit_code == 3) print_refusal(failure.what());
        throw;
    }
}

}  // namespace

void add_check(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<SceneArguments>();
    auto json = std::make_shared<bool>(false);
    CLI::App& command = *parser.add_subcommand("check", "Say whether a scene is valid, its problems and its cost");
    add_scene(command, *arguments);
    command.add_flag("--json", *json, "Print JSON");
    command.callback([=, &session] { session.action = [=, &session] { return check(*arguments, *json, session); }; });
}

}  // namespace fieldwright::app
