// Drawing the palette.
#include "ui/command_palette.h"

#include "ui/command_search.h"
#include "ui/keys.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float width_px = 560;  // design px
constexpr int rows = 12;
constexpr const char* popup_name = "palette";

}  // namespace

std::string CommandPalette::draw(const CommandContext& context, std::span<const Command> commands)
{
    if (std::exchange(asked_, false)) {
        query_.clear();
        highlighted_ = 0;
        ImGui::OpenPopup(popup_name);
    }
    if (!ImGui::IsPopupOpen(popup_name)) return {};
    const Theme& theme = context.frame.theme;
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    float width = std::min(theme.px(width_px), window.Size.x - theme.px(32));
    ImGui::SetNextWindowPos({std::floor(window.Pos.x + (window.Size.x - width) / 2), window.Pos.y + theme.px(72)});
    ImGui::SetNextWindowSize({width, 0});
    std::string chosen;
    if (ImGui::BeginPopup(popup_name, ImGuiWindowFlags_NoMove)) {
        std::vector<const Command*> enabled;
        for (const Command& command : commands)
            if (command.is_enabled(context) && command.id != "help.palette") enabled.push_back(&command);
        chosen = draw_contents(context, enabled);
        if (!chosen.empty() || ImGui::IsKeyPressed(key::escape, false)) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    return chosen;
}

std::string CommandPalette::draw_contents(const CommandContext& context, std::span<const Command* const> enabled)
{
    const Theme& theme = context.frame.theme;
    if (ImGui::IsWindowAppearing()) context.frame.focus_next_text();
    ImGui::SetNextItemWidth(-1);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, colour::window);
    if (ImGui::InputTextWithHint("##search", "What would you like to do?", &query_)) highlighted_ = 0, scroll_ = true;
    context.frame.rects.mark("palette/search");
    ImGui::PopStyleColor();

    std::vector<const Command*> found = search_commands(enabled, query_);
    move_highlight(static_cast<int>(found.size()));
    std::string chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::Dummy({0, theme.gap()});
    float height = theme.row() * static_cast<float>(std::clamp(static_cast<int>(found.size()), 1, rows));
    ImGui::BeginChild("found", {0, height});
    for (std::size_t i = 0; i < found.size(); ++i)
        if (draw_row(context, *found[i], static_cast<int>(i) == highlighted_)) chosen = found[i]->id;
    if (found.empty()) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("  No command is called that.");
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    scroll_ = false;
    bool entered = ImGui::IsKeyPressed(key::enter, false) || ImGui::IsKeyPressed(key::keypad_enter, false);
    if (entered && !found.empty()) chosen = found[static_cast<std::size_t>(highlighted_)]->id;
    return chosen;
}

void CommandPalette::move_highlight(int count)
{
    int before = highlighted_;
    if (ImGui::IsKeyPressed(key::down)) ++highlighted_;
    if (ImGui::IsKeyPressed(key::up)) --highlighted_;
    if (ImGui::IsKeyPressed(key::page_down)) highlighted_ += rows;
    if (ImGui::IsKeyPressed(key::page_up)) highlighted_ -= rows;
    highlighted_ = std::clamp(highlighted_, 0, std::max(count - 1, 0));
    scroll_ = scroll_ || highlighted_ != before;
}

// Icon, title and menu at the left, the shortcut at the right.
bool CommandPalette::draw_row(const CommandContext& context, const Command& command, bool highlighted)
{
    const Theme& theme = context.frame.theme;
    ImVec2 at = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, theme.row());
    ImGui::PushID(command.id.c_str());
    bool clicked = ImGui::InvisibleButton("row", size);
    ImGui::PopID();
    if (!ImGui::IsRectVisible(at, {at.x + size.x, at.y + size.y}) && !(highlighted && scroll_)) return false;
    context.frame.rects.mark("palette/item/" + command.id);
    bool hovered = ImGui::IsItemHovered();
    if (hovered || highlighted) context.frame.view.hint = command.help;
    if (highlighted && scroll_) ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleEdgeY);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (highlighted || hovered)
        list.AddRectFilled(at, {at.x + size.x, at.y + size.y},
                           ImGui::GetColorU32(highlighted ? ImGuiCol_HeaderActive : ImGuiCol_Header), theme.px(4));
    float y = at.y + std::floor((theme.row() - ImGui::GetTextLineHeight()) / 2), x = at.x + theme.px(8);
    list.AddText({x, y}, colour::quiet_text, command.is_checked(context) ? icon::check : command.icon);
    x += theme.px(28);
    list.AddText({x, y}, colour::text, command.title.c_str());
    x += ImGui::CalcTextSize(command.title.c_str()).x + theme.px(12);
    std::string shortcut = first_shortcut_text(command), path = command.menu;
    if (std::size_t slash = path.find('/'); slash != std::string::npos) path.replace(slash, 1, " › ");
    float right = at.x + size.x - theme.px(8) - ImGui::CalcTextSize(shortcut.c_str()).x;
    list.AddText({right, y}, colour::quiet_text, shortcut.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, colour::with_alpha(colour::quiet_text, 0.7f));
    ImGui::RenderTextEllipsis(&list, {x, y}, {right - theme.px(12), y + theme.row()}, right - theme.px(12),
                              right - theme.px(12), path.c_str(), nullptr, nullptr);
    ImGui::PopStyleColor();
    return clicked;
}

}  // namespace fieldwright::ui
