// `new`: a scene file with one node of any type at work in it.
#include "app/baking.h"
#include "app/commands.h"
#include "app/scene_arguments.h"
#include "app/starter_scene.h"
#include "graph/scene_file.h"

namespace fieldwright::app {
namespace {

struct NewArguments {
    std::filesystem::path output;
    std::string node;
    std::vector<std::string> settings;
};

int make_scene(const NewArguments& arguments, const Session& session)
{
    require_place(arguments.output);
    auto library = session.library();
    const graph::NodeType* type = library->type(arguments.node);
    if (!type)
        throw graph::Failure(
            2, "--node: there is no node type `" + arguments.node + "`; `fieldwright nodes` lists them all");
    StarterScene scene(library, *type);
    Baking baking;
    baking.follow(scene.document, *library);
    for (const std::string& setting : arguments.settings) {
        auto [parameter, value] = split_assignment(setting);
        set_from_text(scene.document, *library, scene.shown(), parameter, value);
    }
    baking.bake(scene.document, *library);
    scene.compose();
    graph::save_scene(arguments.output, scene.document, *library);
    return 0;
}

}  // namespace

void add_new(CLI::App& parser, Session& session)
{
    auto arguments = std::make_shared<NewArguments>();
    CLI::App& command = *parser.add_subcommand("new", "Make a small lit scene around one node");
    command.add_option("-o,--output", arguments->output, "The scene file (*.scene.json)")->required();
    command.add_option("--node", arguments->node, "The node's type; `fieldwright nodes` lists them")->required();
    command
        .add_option("--set", arguments->settings, "Set a parameter of that node: parameter=value; angles in degrees")
        ->allow_extra_args(false);
    command.callback(
        [arguments, &session] { session.action = [arguments, &session] { return make_scene(*arguments, session); }; });
}

}  // namespace fieldwright::app
