// Commands of the Render and Help menus.
#include "ui/command_palette.h"
#include "ui/commands.h"
#include "ui/dialogs.h"
#include "ui/keys.h"
#include "ui/shortcut_sheet.h"
#include "ui/transport.h"

namespace fieldwright::ui {
namespace {

const graph::AnimationSettings& animation(const CommandContext& context)
{
    return context.frame.draft.document.animation;
}

void go_to(CommandContext& context, int frame) { go_to_frame(context.frame.view, animation(context), frame); }
void step(CommandContext& context, int frames) { step_frames(context.frame.view, animation(context), frames); }

}  // namespace

void append_render_commands(std::vector<Command>& list)
{
    list.push_back({.id = "render.play",
                    .title = "Play",
                    .menu = "Render",
                    .help = "Plays the scene's animation, or stops it.",
                    .icon = icon::play,
                    .shortcuts = {{.key = key::space, .shift = true}},
                    .checked = [](const CommandContext& context) { return context.frame.view.playing; },
                    .run = [](CommandContext& context) { context.frame.view.playing = !context.frame.view.playing; }});
    list.push_back({.id = "render.loop",
                    .title = "Loop",
                    .menu = "Render",
                    .help = "Begins the animation again after its last frame, or stops there.",
                    .checked = [](const CommandContext& context) { return context.frame.view.looping; },
                    .run = [](CommandContext& context) { context.frame.view.looping = !context.frame.view.looping; }});
    list.push_back({.id = "render.start",
                    .title = "Go to the first frame",
                    .menu = "Render",
                    .help = "Shows the first frame of the animation.",
                    .icon = icon::rewind,
                    .shortcuts = {{.key = key::home, .shift = true}},
                    .separator = true,
                    .run = [](CommandContext& context) { go_to(context, animation(context).first_frame); }});
    list.push_back({.id = "render.end",
                    .title = "Go to the last frame",
                    .menu = "Render",
                    .help = "Shows the last frame of the animation.",
                    .shortcuts = {{.key = key::end, .shift = true}},
                    .run = [](CommandContext& context) { go_to(context, animation(context).last_frame); }});
    list.push_back({.id = "render.previous_frame",
                    .title = "Previous frame",
                    .menu = "Render",
                    .help = "Shows the frame before.",
                    .shortcuts = {{.key = key::left, .shift = true, .repeats = true}},
                    .run = [](CommandContext& context) { step(context, -1); }});
    list.push_back({.id = "render.next_frame",
                    .title = "Next frame",
                    .menu = "Render",
                    .help = "Shows the frame after.",
                    .shortcuts = {{.key = key::right, .shift = true, .repeats = true}},
                    .run = [](CommandContext& context) { step(context, 1); }});
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
