// The list of commands.
#include "ui/commands.h"

namespace fieldwright::ui {

std::span<const Command> commands() { return {}; }
const Command* find_command(std::string_view) { return nullptr; }
std::string shortcut_text(const Shortcut&) { return {}; }

}  // namespace fieldwright::ui
