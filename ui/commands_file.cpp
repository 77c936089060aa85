// Commands of the File menu.
#include "ui/commands.h"
#include "ui/dialogs.h"
#include "ui/keys.h"

#include "graph/words.h"

#include <filesystem>

namespace fieldwright::ui {
namespace {

void ask(CommandContext& context, Request request) { context.frame.requests.push_back(std::move(request)); }

void choose(CommandContext& context, ChooseFile::Then then, std::string target = {})
{
    ask(context, ChooseFile{then, std::move(target)});
}

void append_recent(std::vector<Command>& list, const Readings& readings)
{
    int place = 0;
    for (const RecentFile& recent : readings.recent) {
        std::filesystem::path path(recent.path);
        list.push_back({.id = "file.recent." + std::to_string(++place),
                        .title = path.filename().string(),
                        .menu = "File/Open recent",
                        .help = recent.missing ? recent.path + " is not there now." : "Opens " + recent.path + ".",
                        .enabled = [missing = recent.missing](const CommandContext&) { return !missing; },
                        .run = [path = recent.path](CommandContext& context) { ask(context, OpenFile{path}); }});
    }
    list.push_back({.id = "file.forget_recent",
                    .title = "Forget recent files",
                    .menu = "File/Open recent",
                    .help = "Empties the list of recent files; the files stay.",
                    .separator = place > 0,
                    .enabled = [](const CommandContext& context) { return !context.frame.readings.recent.empty(); },
                    .run = [](CommandContext& context) { ask(context, ForgetRecent{}); }});
}

void append_examples(std::vector<Command>& list, const Readings& readings)
{
    for (const Example& example : readings.examples)
        list.push_back({.id = "file.example." + example.name,
                        .title = example.title,
                        .menu = "File/Open example",
                        .help = example.sentence,
                        .run = [name = example.name](CommandContext& context) { ask(context, OpenExample{name}); }});
}

void append_export(std::vector<Command>& list, const Readings& readings)
{
    bool first = true;
    for (const std::string& target : readings.export_targets) {
        std::string name = target == "glsl" ? "GLSL" : graph::in_words(target);
        list.push_back(
            {.id = "file.export." + target,
             .title = "Export " + name + " shader…",
             .menu = "File",
             .help = "Writes the scene as a shader for " + name + ".",
             .icon = icon::code,
             .separator = first,
             .run = [target](CommandContext& context) { choose(context, ChooseFile::Then::export_shader, target); }});
        first = false;
    }
    list.push_back({.id = "file.export_picture",
                    .title = "Export picture…",
                    .menu = "File",
                    .also_in = "Render",
                    .help = "Writes what the viewport shows as a PNG, JPEG, HDR or EXR file, in full size.",
                    .icon = icon::image,
                    .shortcuts = {{.key = key::f12}},
                    .separator = first,
                    .run = [](CommandContext& context) { choose(context, ChooseFile::Then::export_picture); }});
}

void append_open(std::vector<Command>& list)
{
    list.push_back({.id = "file.new",
                    .title = "New scene",
                    .menu = "File",
                    .help = "Starts a new scene: a solid on a ground, lit by a sun.",
                    .icon = icon::file,
                    .shortcuts = {{.key = 'N', .control = true}},
                    .run = [](CommandContext& context) { ask(context, NewScene{}); }});
    list.push_back({.id = "file.open",
                    .title = "Open…",
                    .menu = "File",
                    .help = "Opens a scene file.",
                    .icon = icon::folder,
                    .shortcuts = {{.key = 'O', .control = true}},
                    .run = [](CommandContext& context) { choose(context, ChooseFile::Then::open); }});
}

void append_save(std::vector<Command>& list)
{
    auto has_file = [](const CommandContext& context) { return !context.frame.readings.file_path.empty(); };
    list.push_back({.id = "file.save",
                    .title = "Save",
                    .menu = "File",
                    .help = "Writes the scene to its file.",
                    .icon = icon::save,
                    .shortcuts = {{.key = 'S', .control = true}},
                    .separator = true,
                    .run = [has_file](CommandContext& context) {
                        if (has_file(context)) ask(context, SaveFile{});
                        else choose(context, ChooseFile::Then::save_as);
                    }});
    list.push_back({.id = "file.save_as",
                    .title = "Save as…",
                    .menu = "File",
                    .help = "Writes the scene to another file and goes on with that one.",
                    .shortcuts = {{.key = 'S', .control = true, .shift = true}},
                    .run = [](CommandContext& context) { choose(context, ChooseFile::Then::save_as); }});
    list.push_back({.id = "file.reload",
                    .title = "Open again from disk",
                    .menu = "File",
                    .help = "Reads the scene's file again and drops what was not saved.",
                    .icon = icon::reset,
                    .enabled = has_file,
                    .run = [](CommandContext& context) { ask(context, OpenFile{context.frame.readings.file_path}); }});
}

}  // namespace

void append_file_commands(std::vector<Command>& list, const Readings& readings)
{
    append_open(list);
    append_recent(list, readings);
    append_examples(list, readings);
    append_save(list);
    append_export(list, readings);
    list.push_back(
        {.id = "file.allow_code",
         .title = "Run the scene's code…",
         .menu = "File",
         .help = "Asks whether the shader code that came with the scene may run.",
         .enabled = [](const CommandContext& context) { return !context.frame.readings.foreign_code.empty(); },
         .run = [](CommandContext& context) { context.dialogs.ask_about_code(); }});
    list.push_back({.id = "file.quit",
                    .title = "Quit",
                    .menu = "File",
                    .help = "Closes the window.",
                    .shortcuts = {{.key = 'Q', .control = true}},
                    .separator = true,
                    .run = [](CommandContext& context) { ask(context, Quit{}); }});
}

}  // namespace fieldwright::ui
