// Drawing the menus and the title.
#include "ui/menu_bar.h"

#include "ui/keys.h"
#include "ui/widgets.h"
#include "ui/workspaces.h"

#include "graph/words.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

// The part of `menu` below `path`, up to the next slash; empty when there is none.
std::string next_level(const std::string& menu, const std::string& path)
{
    if (path.empty()) return menu.substr(0, menu.find('/'));
    if (menu.size() <= path.size() + 1 || menu.compare(0, path.size(), path) != 0 || menu[path.size()] != '/')
        return {};
    return menu.substr(path.size() + 1, menu.find('/', path.size() + 1) - path.size() - 1);
}

// A submenu of Add says "Torus", not "Add torus" again.
std::string title_in(const std::string& path, const std::string& title)
{
    std::size_t slash = path.find('/');
    if (slash == std::string::npos || !title.starts_with(path.substr(0, slash) + ' ')) return title;
    return graph::in_words(title.substr(slash + 1));
}

float text_width(const char* text) { return ImGui::CalcTextSize(text).x; }

}  // namespace

ImVec2 menu_bar_padding(const Theme& theme)
{
    return {theme.padding(), (theme.menu_bar() - theme.fonts.text->FontSize) / 2};
}

std::string MenuBar::draw(const CommandContext& context, std::span<const Command> commands)
{
    context_ = &context;
    commands_ = commands;
    chosen_.clear();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, menu_bar_padding(context.frame.theme));
    bool open = ImGui::BeginMenuBar();
    ImGui::PopStyleVar();
    if (!open) return {};
    ImGui::SetCursorPosX(context.frame.theme.gap());
    draw_menus();
    float left_px = ImGui::GetCursorScreenPos().x;
    draw_title(left_px, draw_palette_button());
    ImGui::EndMenuBar();
    return chosen_;
}

void MenuBar::draw_menus()
{
    std::vector<std::string> seen;
    for (const Command& command : commands_) {
        std::string title = next_level(command.menu, "");
        if (std::find(seen.begin(), seen.end(), title) != seen.end()) continue;
        seen.push_back(title);
        draw_menu(title, title);
    }
}

// An item that opens `path`, in the bar or in another menu.
void MenuBar::draw_menu(const std::string& title, const std::string& path)
{
    const Theme& theme = context_->frame.theme;
    bool in_bar = path.find('/') == std::string::npos;
    ImVec2 low = ImGui::GetCursorScreenPos();
    float width = in_bar ? text_width(title.c_str()) + theme.padding() : ImGui::GetContentRegionAvail().x;
    float height = in_bar ? theme.menu_bar() : ImGui::GetTextLineHeight();
    context_->frame.rects.mark("menu/" + path, {{low.x, low.y}, {low.x + width, low.y + height}});

    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(8), theme.px(8)});
    bool open = ImGui::BeginMenu(title.c_str());
    ImGui::PopStyleVar();
    if (!open) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(12), theme.row() - ImGui::GetTextLineHeight()});
    draw_entries(path);
    ImGui::PopStyleVar();
    if (in_bar && ImGui::IsKeyPressed(key::escape, false)) ImGui::CloseCurrentPopup();
    ImGui::EndMenu();
}

void MenuBar::draw_entries(const std::string& path)
{
    std::vector<const Command*> entries;
    for (const Command& command : commands_)
        if (command.menu == path) entries.push_back(&command);
    std::size_t rows = rows_that_fit();
    if (entries.size() > rows) return draw_columns(entries, path, rows);
    std::vector<std::string> seen;
    bool first = true;
    for (const Command& command : commands_) {
        if (command.menu == path || command.also_in == path) {
            draw_entry(command, path, first);
            first = false;
            continue;
        }
        std::string level = next_level(command.menu, path);
        if (level.empty() || std::find(seen.begin(), seen.end(), level) != seen.end()) continue;
        seen.push_back(level);
        if (command.separator && !first) draw_separator();
        draw_menu(level, path + "/" + level);
        first = false;
    }
}

std::size_t MenuBar::rows_that_fit() const
{
    const Theme& theme = context_->frame.theme;
    float room = ImGui::GetMainViewport()->Size.y - 2 * theme.menu_bar() - 2 * theme.px(8);
    return static_cast<std::size_t>(std::max(room / theme.row(), 8.0f));
}

// A category of the library may be longer than the window is high: columns of one length, read downwards.
void MenuBar::draw_columns(const std::vector<const Command*>& entries, const std::string& path, std::size_t rows)
{
    std::size_t columns = (entries.size() + rows - 1) / rows;
    rows = (entries.size() + columns - 1) / columns;
    if (!ImGui::BeginTable("columns", static_cast<int>(columns), ImGuiTableFlags_SizingFixedFit)) return;
    for (std::size_t row = 0; row < rows; ++row) {
        ImGui::TableNextRow();
        for (std::size_t column = 0; column < columns && column * rows + row < entries.size(); ++column) {
            ImGui::TableSetColumnIndex(static_cast<int>(column));
            draw_entry(*entries[column * rows + row], path, true);
        }
    }
    ImGui::EndTable();
}

void MenuBar::draw_separator() const
{
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, context_->frame.theme.px(5)});
    ImGui::Separator();
    ImGui::PopStyleVar();
}

void MenuBar::draw_entry(const Command& command, const std::string& path, bool first)
{
    FrameContext& frame = context_->frame;
    if ((command.separator || command.also_in == path) && !first) draw_separator();
    ImGui::PushID(command.id.c_str());
    if (ImGui::MenuItemEx(title_in(path, command.title).c_str(), command.icon, first_shortcut_text(command).c_str(),
                          command.is_checked(*context_), command.is_enabled(*context_)))
        chosen_ = command.id;
    frame.rects.mark("menu/" + command.id);
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) frame.view.hint = command.help;
    ImGui::PopID();
}

// The scene's name in the middle of the bar, or of the room that is left; a dot says that it is not saved.
void MenuBar::draw_title(float left_px, float right_px) const
{
    const FrameContext& frame = context_->frame;
    const Theme& theme = frame.theme;
    std::string title = frame.readings.file_name + (frame.readings.dirty ? " •" : "");
    const char* warning = frame.readings.changed_on_disk ? "Changed on disk" : "";
    float width = text_width(title.c_str());
    float warning_width = *warning ? text_width(warning) + theme.px(16) : 0;
    left_px += theme.px(16);
    right_px -= theme.px(16);
    if (right_px - left_px < theme.px(40)) return;

    ImVec2 window = ImGui::GetWindowPos();
    float middle = window.x + ImGui::GetWindowWidth() / 2 - (width + warning_width) / 2;
    ImVec2 at(std::max(std::min(middle, right_px - width - warning_width), left_px),
              window.y + (theme.menu_bar() - ImGui::GetTextLineHeight()) / 2);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::PushStyleColor(ImGuiCol_Text, frame.readings.dirty ? colour::text : colour::quiet_text);
    ImGui::RenderTextEllipsis(&list, at, {right_px, at.y + theme.row()}, right_px, right_px, title.c_str(), nullptr,
                              nullptr);
    ImGui::PopStyleColor();
    if (at.x + width + warning_width <= right_px)
        list.AddText({at.x + width + theme.px(16), at.y}, colour::warning, warning);
    frame.rects.mark("menu/title", {{at.x, at.y}, {std::min(at.x + width, right_px), at.y + theme.row()}});
}

// Side by side up to `right_px`; where they begin.
float MenuBar::draw_workspaces(float right_px)
{
    FrameContext& frame = context_->frame;
    const Theme& theme = frame.theme;
    float inset = theme.px(10), width = theme.px(16), window = ImGui::GetWindowPos().x;
    for (const Workspace& workspace : workspaces()) width += text_width(workspace.title) + 2 * inset;
    if (ImGui::GetWindowWidth() < theme.px(1000)) return right_px;
    float x = std::floor(right_px - width);
    float left = x, top = ImGui::GetWindowPos().y + theme.px(2), height = theme.menu_bar() - theme.px(4);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const Workspace& workspace : workspaces()) {
        float wide = text_width(workspace.title) + 2 * inset;
        ImGui::SetCursorPos({x - window, theme.px(2)});
        if (ImGui::InvisibleButton(workspace.id, {wide, height})) chosen_ = std::string("workspace.") + workspace.id;
        frame.rects.mark(std::string("menu/workspace/") + workspace.id);
        bool holds = workspace.holds(frame.view), hovered = ImGui::IsItemHovered();
        if (holds || hovered)
            list.AddRectFilled({x, top}, {x + wide, top + height}, holds ? colour::chosen : colour::field, theme.px(4));
        list.AddText({x + inset, top + std::floor(0.5f * (height - ImGui::GetFontSize()))},
                     holds || hovered ? colour::text : colour::quiet_text, workspace.title);
        if (hovered) frame.view.hint = workspace.help;
        x += wide;
    }
    return left;
}

// At the right end, while there is room; where it begins.
float MenuBar::draw_palette_button()
{
    const Theme& theme = context_->frame.theme;
    float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
    const Command* palette = find_command(commands_, "help.palette");
    if (!palette || ImGui::GetWindowWidth() < theme.px(900)) return right;
    std::string text = std::string(palette->icon) + "  " + first_shortcut_text(*palette);
    float width = text_width(text.c_str()) + theme.px(24);
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width);
    ImGui::PushStyleColor(ImGuiCol_Text, colour::quiet_text);
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
    if (ImGui::Button((text + "##palette").c_str(), {width - theme.gap(), theme.menu_bar()})) chosen_ = palette->id;
    ImGui::PopStyleColor(2);
    context_->frame.rects.mark("menu/palette");
    tooltip(context_->frame, with_shortcut("Find a command", palette->id));
    if (ImGui::IsItemHovered()) context_->frame.view.hint = palette->help;
    return draw_workspaces(right - width);
}

}  // namespace fieldwright::ui
