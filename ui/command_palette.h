// The palette: type what you want to do, press Enter.
#pragma once

#include "ui/commands.h"

namespace fieldwright::ui {

class CommandPalette {
public:
    void open() { asked_ = true; }  // shown when it is next drawn
    // Draws above everything; the id of the command that was chosen, or nothing.
    std::string draw(const CommandContext& context, std::span<const Command> commands);

private:
    std::string draw_contents(const CommandContext& context, std::span<const Command* const> enabled);
    bool draw_row(const CommandContext& context, const Command& command, bool highlighted);
    void move_highlight(int count);

    bool asked_ = false, scroll_ = false;
    std::string query_;
    int highlighted_ = 0;
};

}  // namespace fieldwright::ui
