// Commands of the Render and Help menus.
#include "ui/command_palette.h"
#include "ui/commands.h"
#include "ui/dialogs.h"
#include "ui/keys.h"
#include "ui/shortcut_sheet.h"

namespace fieldwright::ui {

void append_render_commands(std::vector<Command>& list)
{
    list.push_back({.id = "render.play",
                    .title = "Play",
                    .menu = "Render",
                    .help = "Lets the scene's time run, or stops it.",
                    .icon = icon::play,
                    .shortcuts = {{.key = key::space, .shift = true}},
                    .checked = [](const CommandContext& context) { return context.frame.view.playing; },
                    .run = [](CommandContext& context) { context.frame.view.playing = !context.frame.view.playing; }});
    list.push_back({.id = "render.start",
                    .title = "Go to the start",
                    .menu = "Render",
                    .help = "Sets the scene's time to zero.",
                    .icon = icon::rewind,
                    .shortcuts = {{.key = key::home, .shift = true}},
                    .run = [](CommandContext& context) { context.frame.view.time_s = 0; }});
}

void append_help_commands(std::vector<Command>& list)
{
    list.push_back({.id = "help.shortcuts",
                    .title = "Shortcuts",
                    .menu = "Help",
                    .help = "Shows every shortcut on one sheet.",
                    .icon = icon::question,
                    .shortcuts = {{.key = key::f1}},
                    .run = [](CommandContext& context) { context.sheet.open(); }});
    list.push_back(
        {.id = "help.palette",
         .title = "Find a command…",
         .menu = "Help",
         .help = "Finds a command by what it does and runs it.",
         .icon = icon::search,
         .shortcuts = {{.key = 'P', .control = true}, {.key = 'P', .control = true, .shift = true}, {.key = key::f3}},
         .run = [](CommandContext& context) { context.palette.open(); }});
    list.push_back({.id = "help.about",
                    .title = "About Fieldwright",
                    .menu = "Help",
                    .help = "Says what this program is.",
                    .icon = icon::info,
                    .separator = true,
                    .run = [](CommandContext& context) { context.dialogs.show_about(); }});
}

}  // namespace fieldwright::ui
