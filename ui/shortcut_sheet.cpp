// Drawing the sheet.
#include "ui/shortcut_sheet.h"

#include "ui/keys.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr std::size_t column_limit = 3;

// What the hands do is no command, but belongs on the sheet.
struct Gesture {
    const char *hand, *place, *what;
};
constexpr Gesture gestures[] = {
    {"Drag, middle drag", "Viewport", "Orbit"},
    {"Shift+drag", "Viewport", "Pan"},
    {"Ctrl+drag, wheel", "Viewport", "Come closer"},
    {"Click", "Viewport", "Select what is seen"},
    {"Drag", "Node canvas", "Select in a box"},
    {"Ctrl+Alt+drag", "Node canvas", "Select in a lasso"},
    {"Right drag, middle drag", "Node canvas", "Pan"},
    {"Wheel", "Node canvas", "Zoom"},
    {"Drag from a pin", "Node canvas", "Wire"},
    {"Drop on a wire", "Node canvas", "Insert; Alt: do not"},
    {"Ctrl+drag an output", "Node canvas", "Move all its wires"},
    {"Ctrl+right drag", "Node canvas", "Cut wires"},
    {"Alt+click a pin", "Node canvas", "Remove its wires"},
    {"Right click", "Node canvas", "Open a menu"},
};

struct Row {
    std::string keys, title;
    std::string mark = {};
};
struct Section {
    std::string title;
    std::vector<Row> rows;
    std::size_t height() const { return rows.size() + 2; }  // with its title, and a space below
};
using Column = std::vector<const Section*>;

// "Tab, Shift+A, Space": each once, whatever its scope.
std::string all_shortcuts(const Command& command)
{
    std::vector<std::string> texts;
    for (const Shortcut& shortcut : command.shortcuts)
        if (std::string text = shortcut_text(shortcut); std::find(texts.begin(), texts.end(), text) == texts.end())
            texts.push_back(text);
    std::string joined;
    for (const std::string& text : texts) joined += (joined.empty() ? "" : ", ") + text;
    return joined;
}

// Where it works; its menu when that is everywhere.
std::string section_of(const Command& command)
{
    auto has = [&](Scope scope) {
        return std::any_of(command.shortcuts.begin(), command.shortcuts.end(),
                           [&](const Shortcut& shortcut) { return shortcut.scope == scope; });
    };
    if (has(Scope::everywhere) || (has(Scope::canvas) && has(Scope::viewport)))
        return command.menu.substr(0, command.menu.find('/'));
    return has(Scope::canvas) ? "Node canvas" : "Viewport";
}

std::string without_dots(std::string title)
{
    constexpr std::string_view dots = "…";
    if (title.ends_with(dots)) title.resize(title.size() - dots.size());
    return title;
}

Section& section_called(const std::string& title, std::vector<Section>& sections)
{
    auto found = std::find_if(sections.begin(), sections.end(), [&](const Section& s) { return s.title == title; });
    return found == sections.end() ? sections.emplace_back(Section{title, {}}) : *found;
}

std::vector<Section> sections_of(std::span<const Command> commands)
{
    std::vector<Section> sections;
    for (const Command& command : commands) {
        if (command.shortcuts.empty()) continue;
        section_called(section_of(command), sections)
            .rows.push_back({all_shortcuts(command), without_dots(command.title), command.id});
    }
    for (const Gesture& gesture : gestures)
        section_called(gesture.place, sections).rows.push_back({gesture.hand, gesture.what});
    return sections;
}

std::vector<Column> columns_within(const std::vector<Section>& sections, std::size_t height)
{
    std::vector<Column> columns(1);
    std::size_t filled = 0;
    for (const Section& section : sections) {
        if (filled > 0 && filled + section.height() > height) columns.emplace_back(), filled = 0;
        columns.back().push_back(&section);
        filled += section.height();
    }
    return columns;
}

// Sections in order, in columns as low as possible.
std::vector<Column> columns_of(const std::vector<Section>& sections)
{
    std::size_t height = 1;
    for (;; ++height)
        if (std::vector<Column> columns = columns_within(sections, height); columns.size() <= column_limit)
            return columns;
}

void draw_row(FrameContext& frame, const Row& row, float x, float keys_width)
{
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::TextDisabled("%s", row.keys.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(x + keys_width);
    ImGui::TextUnformatted(row.title.c_str());
    ImVec2 high = ImGui::GetItemRectMax();
    if (!row.mark.empty()) frame.rects.mark("sheet/" + row.mark, {{low.x, low.y}, {high.x, high.y}});
}

void draw_section(FrameContext& frame, const Section& section, float x, float keys_width)
{
    ImGui::SetCursorPosX(x);
    ImGui::PushFont(frame.theme.fonts.heading);
    ImGui::TextUnformatted(section.title.c_str());
    ImGui::PopFont();
    for (const Row& row : section.rows) {
        ImGui::SetCursorPosX(x);
        draw_row(frame, row, x, keys_width);
    }
    ImGui::Dummy({0, frame.theme.px(8)});
}

struct Widths {
    float keys = 0, titles = 0;
};

Widths widths_of(const Column& column)
{
    Widths widths;
    for (const Section* section : column)
        for (const Row& row : section->rows) {
            widths.keys = std::max(widths.keys, ImGui::CalcTextSize(row.keys.c_str()).x);
            widths.titles = std::max(widths.titles, ImGui::CalcTextSize(row.title.c_str()).x);
        }
    return widths;
}

// Each as wide as its words, closer together where there is less room.
void draw_columns(FrameContext& frame, const std::vector<Section>& sections)
{
    const Theme& theme = frame.theme;
    ImVec2 start = ImGui::GetCursorPos();
    std::vector<Column> columns = columns_of(sections);
    std::vector<Widths> widths;
    float room = ImGui::GetMainViewport()->Size.x - theme.px(72), x = start.x;
    for (const Column& column : columns) {
        widths.push_back(widths_of(column));
        widths.back().keys += theme.px(12);
        room -= widths.back().keys + widths.back().titles;
    }
    float gap = std::floor(
        std::clamp(room / static_cast<float>(std::max(columns.size(), std::size_t{2}) - 1), theme.px(8), theme.px(40)));
    for (std::size_t i = 0; i < columns.size(); ++i) {
        ImGui::SetCursorPosY(start.y);
        for (const Section* section : columns[i]) draw_section(frame, *section, x, widths[i].keys);
        x += widths[i].keys + widths[i].titles + gap;
    }
}

}  // namespace

void ShortcutSheet::draw(FrameContext& frame, std::span<const Command> commands)
{
    const char* name = "Shortcuts";
    bool appearing = asked_;
    if (std::exchange(asked_, false)) ImGui::OpenPopup(name);
    if (!ImGui::IsPopupOpen(name)) return;
    const Theme& theme = frame.theme;
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(
        {std::floor(window.Pos.x + window.Size.x / 2), std::floor(window.Pos.y + window.Size.y / 2)}, ImGuiCond_Always,
        {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.Size.x - theme.px(32), window.Size.y - theme.px(32)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(20), theme.px(16)});
    bool open = ImGui::BeginPopup(name, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    if (!open) return;
    ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    frame.rects.mark("sheet", {{low.x, low.y}, {low.x + size.x, low.y + size.y}});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(8), theme.px(6)});
    draw_columns(frame, sections_of(commands));
    ImGui::PopStyleVar();
    if (!appearing && (ImGui::IsKeyPressed(key::f1, false) || ImGui::IsKeyPressed(key::escape, false)))
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace fieldwright::ui
