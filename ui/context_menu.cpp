// Drawing context menus.
#include "ui/context_menu.h"

#include "ui/commands.h"

namespace fieldwright::ui {

ContextMenu::ContextMenu(const char* name, const Theme& theme)
{
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.padding(), theme.row() - ImGui::GetFontSize()});
    open = ImGui::BeginPopup(name);
}

ContextMenu::~ContextMenu()
{
    if (open) ImGui::EndPopup();
    ImGui::PopStyleVar();
}

bool menu_item(FrameContext& frame, const char* name, const char* title, const char* command, bool enabled)
{
    const Command* found = find_command(command);
    std::string shortcut = found && !found->shortcuts.empty() ? shortcut_text(found->shortcuts.front()) : "";
    bool chosen = ImGui::MenuItem(title, shortcut.c_str(), false, enabled);
    frame.rects.mark(std::string("canvas/menu/") + name);
    return chosen;
}

}  // namespace fieldwright::ui
