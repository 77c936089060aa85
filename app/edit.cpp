// `edit`: the editor window. `fieldwright SCENE` and `fieldwright` alone mean it too.
#include "app/commands.h"
#include "app/workbench.h"

namespace fieldwright::app {

int edit(const std::filesystem::path& scene, const Session& session)
{
    return Workbench({.scene = scene, .shaders = session.shaders}).run();
}

void add_edit(CLI::App& parser, Session& session)
{
    auto options = std::make_shared<WorkbenchOptions>();
    auto size = std::make_shared<std::pair<int, int>>(options->size.x, options->size.y);
    CLI::App& command = *parser.add_subcommand("edit", "Open the editor window");
    command.add_option("scene", options->scene, "The scene (*.scene.json); a new one when left out");
    command.add_option("--script", options->script, "Play the actions of this file");
    command.add_option("--places", options->places,
                       "Write where widgets stand to this file whenever the window is at rest");
    command.add_option("--record", options->recording, "Write the input events to this file at the end");
    command.add_option("--state", options->state, "Remember recent files, views and autosaves in this folder");
    command.add_option("--window", *size, "Width and height in pixels")->capture_default_str();
    command.callback([options, size, &session] {
        options->shaders = session.shaders;
        options->size = {size->first, size->second};
        session.action = [options] { return Workbench(*options).run(); };
    });
}

}  // namespace fieldwright::app
