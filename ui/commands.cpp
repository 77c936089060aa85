// The list of commands as a whole, and the keys that reach it.
#include "ui/commands.h"

#include "ui/keys.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>

namespace fieldwright::ui {
namespace {

struct KeyName {
    int key;
    const char* name;
};
constexpr KeyName key_names[] = {{key::space, "Space"},
                                 {key::period, "."},
                                 {key::comma, ","},
                                 {key::minus, "-"},
                                 {key::slash, "/"},
                                 {key::equal, "="},
                                 {key::escape, "Esc"},
                                 {key::enter, "Enter"},
                                 {key::tab, "Tab"},
                                 {key::backspace, "Backspace"},
                                 {key::insert, "Insert"},
                                 {key::del, "Delete"},
                                 {key::right, "Right"},
                                 {key::left, "Left"},
                                 {key::down, "Down"},
                                 {key::up, "Up"},
                                 {key::page_up, "Page up"},
                                 {key::page_down, "Page down"},
                                 {key::home, "Home"},
                                 {key::end, "End"},
                                 {key::keypad_decimal, "Numpad ."},
                                 {key::keypad_enter, "Numpad Enter"}};

std::string key_name(int code)
{
    for (const KeyName& named : key_names)
        if (named.key == code) return named.name;
    if (code >= key::f1 && code <= key::f12) return "F" + std::to_string(code - key::f1 + 1);
    if (code >= key::keypad_0 && code <= key::keypad_9) return "Numpad " + std::to_string(code - key::keypad_0);
    return std::string(1, static_cast<char>(code));
}

bool is_pressed(const Shortcut& shortcut)
{
    const ImGuiIO& io = ImGui::GetIO();
    return shortcut.key != 0 && io.KeyCtrl == shortcut.control && io.KeyShift == shortcut.shift &&
           io.KeyAlt == shortcut.alt && !io.KeySuper && ImGui::IsKeyPressed(shortcut.key, shortcut.repeats);
}

const std::vector<Command>& fixed_commands()
{
    static const std::vector<Command> list = [] {
        std::vector<Command> commands;
        append_file_commands(commands, {});
        append_edit_commands(commands, {});
        append_view_commands(commands, {});
        append_render_commands(commands);
        append_help_commands(commands);
        return commands;
    }();
    return list;
}

}  // namespace

std::vector<Command> commands(const Readings& readings, const graph::Library& library)
{
    std::vector<Command> list;
    append_file_commands(list, readings);
    append_edit_commands(list, readings);
    append_add_commands(list, library);
    append_view_commands(list, readings);
    append_render_commands(list);
    append_help_commands(list);
    return list;
}

const Command* find_command(std::span<const Command> list, std::string_view id)
{
    auto found = std::find_if(list.begin(), list.end(), [&](const Command& command) { return command.id == id; });
    return found == list.end() ? nullptr : &*found;
}

const Command* find_command(std::string_view id) { return find_command(fixed_commands(), id); }

std::string shortcut_text(const Shortcut& shortcut)
{
    if (shortcut.key == 0) return {};
    std::string text;
    if (shortcut.control) text += "Ctrl+";
    if (shortcut.shift) text += "Shift+";
    if (shortcut.alt) text += "Alt+";
    return text + key_name(shortcut.key);
}

std::string first_shortcut_text(const Command& command)
{
    return command.shortcuts.empty() ? std::string() : shortcut_text(command.shortcuts.front());
}

std::string with_shortcut(std::string tip, std::string_view command_id)
{
    const Command* command = find_command(command_id);
    std::string shortcut = command ? first_shortcut_text(*command) : "";
    return shortcut.empty() ? tip : tip + " (" + shortcut + ")";
}

const Command* pressed_command(std::span<const Command> list, Scope over)
{
    for (const Command& command : list)
        for (const Shortcut& shortcut : command.shortcuts)
            if ((shortcut.scope == Scope::everywhere || shortcut.scope == over) && is_pressed(shortcut))
                return &command;
    return nullptr;
}

}  // namespace fieldwright::ui
