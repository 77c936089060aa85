// `export`: a scene as a readable shader for another program.
#include "app/commands.h"
#include "app/scene_arguments.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"
#include "graph/scene_file.h"

namespace fieldwright::app {
namespace {

struct ExportArguments {
    SceneArguments scene;
    std::string target;
    std::filesystem::path output;
};

int export_scene(const ExportArguments& arguments, const Session& session)
{
    require_place(arguments.output);
    auto [document, library] = open_document(arguments.scene, session.library());
    // No export shows ids, and all are read by people.
    graph::Program program = lower_scene(arguments.scene, document, library, {.ids = false, .fold_moves = false});
    report_problems(program, document);
    if (std::string refusal = codegen::export_refusal(program); !refusal.empty())
        throw graph::Failure(3, arguments.scene.path.string() + ": " + refusal);
    std::vector<float> block = field::evaluate_frame(program, arguments.scene.time);
    graph::save_atomically(arguments.output, codegen::print_export(program, document, block, arguments.target));
    return 0;
}

}  // namespace

void add_export(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<ExportArguments>();
    CLI::App& command = *parser.add_subcommand("export", "Write a scene as a shader");
    add_scene(command, arguments->scene);
    command.add_option("--target", arguments->target, "Which kind of shader")
        ->required()
        ->check(CLI::IsMember(codegen::export_targets()));
    command.add_option("-o,--output", arguments->output, "The shader file")->required();
    add_changes(command, arguments->scene);
    command.callback([arguments, &session] {
        session.action = [arguments, &session] { return export_scene(*arguments, session); };
    });
}

}  // namespace fieldwright::app
