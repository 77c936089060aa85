// Every command of the window, once: menus, shortcuts, the palette and the shortcut sheet are derived from this list.
#pragma once

#include "ui/frame_context.h"

#include <functional>
#include <span>

namespace fieldwright::ui {

class Canvas;
class Viewport;

// What a command may use.
struct CommandContext {
    FrameContext& frame;
    Canvas& canvas;
    Viewport& viewport;
};

// A shortcut fires only while the mouse is over its scope's pane, and no text is being typed.
enum class Scope { everywhere, canvas, viewport };

struct Shortcut {
    int key = 0;  // ui::key; 0 = none
    bool control = false, shift = false, alt = false;
    Scope scope = Scope::everywhere;
    bool operator==(const Shortcut&) const = default;
};

struct Command {
    std::string id;     // "edit.undo"
    std::string title;  // "Undo"
    std::string menu;   // "Edit"; "Edit/Align" for a submenu
    std::string help;   // one sentence
    const char* icon = "";
    std::vector<Shortcut> shortcuts;                     // the first is shown in menus
    bool separator = false;                              // a line above it in its menu
    std::function<bool(const CommandContext&)> enabled;  // empty = always
    std::function<bool(const CommandContext&)> checked;  // empty = no check mark
    std::function<void(CommandContext&)> run;
};

// All of them, in menu order.
std::span<const Command> commands();
const Command* find_command(std::string_view id);
std::string shortcut_text(const Shortcut& shortcut);  // "Ctrl+Shift+Z"

}  // namespace fieldwright::ui
