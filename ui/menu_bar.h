// The bar on top: the menus, derived from the commands, the scene's name, and the way to the palette.
#pragma once

#include "ui/commands.h"

namespace fieldwright::ui {

// ImGuiStyle::FramePadding that makes the bar as high as the theme says; of the window when it begins, and of the bar.
ImVec2 menu_bar_padding(const Theme& theme);

class MenuBar {
public:
    // Draws into the menu bar of the current window; the id of the command that was chosen, or nothing.
    std::string draw(const CommandContext& context, std::span<const Command> commands);

private:
    void draw_menus();
    void draw_menu(const std::string& title, const std::string& path);
    void draw_entries(const std::string& path);
    void draw_entry(const Command& command, const std::string& path, bool first);
    std::size_t rows_that_fit() const;
    void draw_columns(const std::vector<const Command*>& entries, const std::string& path, std::size_t rows);
    void draw_separator() const;
    void draw_title(float left_px, float right_px) const;
    float draw_palette_button();
    float draw_workspaces(float right_px);

    // Of the frame being drawn.
    const CommandContext* context_ = nullptr;
    std::span<const Command> commands_;
    std::string chosen_;
};

}  // namespace fieldwright::ui
