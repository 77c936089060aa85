// Every command of the window, once: menus, shortcuts, the palette and the shortcut sheet are derived from this list.
#pragma once

#include "ui/frame_context.h"

#include <functional>
#include <span>

namespace fieldwright::ui {

class Canvas;
class Viewport;
class CommandPalette;
class ShortcutSheet;
class Dialogs;

// What a command may use.
struct CommandContext {
    FrameContext& frame;
    Canvas& canvas;
    Viewport& viewport;
    CommandPalette& palette;
    ShortcutSheet& sheet;
    Dialogs& dialogs;
};

// A shortcut fires only while the mouse is over its scope's pane, and no text is being typed.
enum class Scope { everywhere, canvas, viewport };

struct Shortcut {
    int key = 0;  // ui::key; 0 = none
    bool control = false, shift = false, alt = false;
    Scope scope = Scope::everywhere;
    bool repeats = false;  // while the key is held
    bool operator==(const Shortcut&) const = default;
};

struct Command {
    std::string id = {};       // "edit.undo"
    std::string title = {};    // "Undo"
    std::string menu = {};     // "Edit"; "Edit/Align" for a submenu
    std::string also_in = {};  // a second menu that shows it
    std::string help = {};     // one sentence
    const char* icon = "";
    std::vector<Shortcut> shortcuts = {};                     // the first is shown in menus
    bool separator = false;                                   // a line above it in its menu
    std::function<bool(const CommandContext&)> enabled = {};  // empty = always
    std::function<bool(const CommandContext&)> checked = {};  // empty = no check mark
    std::function<void(CommandContext&)> run = {};

    bool is_enabled(const CommandContext& context) const { return !enabled || enabled(context); }
    bool is_checked(const CommandContext& context) const { return checked && checked(context); }
};

// All of them, in menu order: the fixed ones, and one for each recent file, export target, view and node type.
std::vector<Command> commands(const Readings& readings, const graph::Library& library);
// One of `list`, or of the fixed ones, for the tooltip of a button that does the same; null when there is none.
const Command* find_command(std::span<const Command> list, std::string_view id);
const Command* find_command(std::string_view id);
std::string shortcut_text(const Shortcut& shortcut);      // "Ctrl+Shift+Z"; empty for no key
std::string first_shortcut_text(const Command& command);  // empty when it has none
// "Undo (Ctrl+Z)": the tooltip of a button that does what a fixed command does.
std::string with_shortcut(std::string tip, std::string_view command_id);
// The command of a shortcut that is pressed in this frame, with the mouse over `over`; null when there is none.
const Command* pressed_command(std::span<const Command> list, Scope over);

// The parts of the list, one a menu.
void append_file_commands(std::vector<Command>& list, const Readings& readings);
void append_edit_commands(std::vector<Command>& list, const Readings& readings);
void append_group_commands(std::vector<Command>& list);
void append_add_commands(std::vector<Command>& list, const graph::Library& library);
void append_view_commands(std::vector<Command>& list, const Readings& readings);
void append_render_commands(std::vector<Command>& list);
void append_help_commands(std::vector<Command>& list);

}  // namespace fieldwright::ui
