// The tabs, and the panel that the chosen one shows.
#include "ui/panels.h"

#include "graph/groups.h"

#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <iterator>

namespace fieldwright::ui {
namespace {

struct Tab {
    Panel panel;
    const char *name, *title, *tip;
};

constexpr Tab tabs[] = {
    {Panel::materials, "materials", "Materials", "What surfaces are made of"},
    {Panel::lights, "lights", "Lights", "What shines: the sun and lamps"},
    {Panel::camera, "camera", "Camera", "Where the picture is seen from, and the sky behind it"},
    {Panel::cost, "cost", "Cost", "What the scene asks of the machine, and the steps heatmap"},
    {Panel::field, "field", "Field", "The field on a plane, and the way of a ray through it"},
    {Panel::stereo, "stereo", "Stereo", "Pictures for two eyes, and how comfortable they are"},
    {Panel::shader, "shader", "Shader", "The live GLSL of the scene, and its export"},
    {Panel::problems, "problems", "Problems", "What is wrong with the scene, and where"},
    {Panel::history, "history", "History", "The steps that were made; click one to go back to it"},
};

std::string count_text(std::size_t count) { return count > 99 ? "99+" : std::to_string(count); }

ImVec2 badge_size(const FrameContext& frame, const std::string& text)
{
    float height = frame.theme.px(16);
    float width = frame.theme.fonts.small->CalcTextSizeA(frame.theme.px(12), FLT_MAX, 0, text.c_str()).x;
    return {std::max(width + frame.theme.px(8), height), height};
}

void badge(const FrameContext& frame, ImVec2 at, const std::string& text, ImU32 tint)
{
    ImFont* font = frame.theme.fonts.small;
    float font_px = frame.theme.px(12);
    ImVec2 extent = font->CalcTextSizeA(font_px, FLT_MAX, 0, text.c_str()), size = badge_size(frame, text);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, tint, 0.5f * size.y);
    draw.AddText(font, font_px, {at.x + 0.5f * (size.x - extent.x), at.y + 0.5f * (size.y - extent.y)}, colour::window,
                 text.c_str());
}

ImU32 worst_tint(const std::vector<graph::Problem>& problems)
{
    bool error = std::any_of(problems.begin(), problems.end(), [](const graph::Problem& problem) {
        return problem.severity == graph::Problem::Severity::error;
    });
    return error ? colour::error : colour::warning;
}

void tab(FrameContext& frame, const Tab& entry, float width_px)
{
    const Theme& theme = frame.theme;
    bool active = frame.view.panel == entry.panel;
    ImVec2 low = ImGui::GetCursorScreenPos(), size(width_px, theme.row());
    if (ImGui::InvisibleButton(entry.name, size)) frame.view.panel = entry.panel;
    frame.rects.mark(std::string("panel/tab/") + entry.name);
    bool hovered = ImGui::IsItemHovered();
    tooltip(frame, entry.tip);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (active || hovered)
        draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, active ? colour::chosen : colour::field, theme.px(4));
    const auto& problems = frame.readings.problems;
    bool counted = entry.panel == Panel::problems && !problems.empty();
    std::string count = counted ? count_text(problems.size()) : "";
    ImVec2 extent = counted ? badge_size(frame, count) : ImVec2(0, 0);
    float gap = counted ? theme.px(4) : 0, text = ImGui::CalcTextSize(entry.title).x;
    float x = low.x + std::floor(0.5f * (size.x - text - gap - extent.x));
    draw.AddText({x, low.y + std::floor(0.5f * (size.y - ImGui::GetFontSize()))},
                 active || hovered ? colour::text : colour::quiet_text, entry.title);
    if (counted)
        badge(frame, {x + text + gap, low.y + std::floor(0.5f * (size.y - extent.y))}, count, worst_tint(problems));
}

// Words, in one row where they fit, else in two.
void tab_bar(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    float room = ImGui::GetContentRegionAvail().x;
    int columns = room >= theme.px(660) ? static_cast<int>(std::size(tabs)) : 5;
    float gap = theme.px(2), left = ImGui::GetCursorPosX();
    float pitch = (room + gap) / static_cast<float>(columns);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, gap));
    for (int i = 0; i < static_cast<int>(std::size(tabs)); ++i) {
        auto column = static_cast<float>(i % columns);
        float from = std::round(column * pitch), to = std::round((column + 1) * pitch) - gap;
        if (i % columns) ImGui::SameLine();
        ImGui::SetCursorPosX(left + from);
        tab(frame, tabs[i], to - from);
    }
    ImGui::PopStyleVar();
    ImVec2 low = ImGui::GetCursorScreenPos();
    float y = low.y + theme.px(2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, y}, {low.x + room, y + theme.px(1)}, colour::line);
    ImGui::Dummy({0, theme.px(3)});
}

}  // namespace

void Panels::draw(FrameContext& frame)
{
    tab_bar(frame);
    ImGui::Dummy({0, frame.theme.px(2)});
    // Of its own, so that the tabs stay when the page scrolls, and each page keeps its place.
    ImGui::BeginChild(static_cast<ImGuiID>(1 + static_cast<int>(frame.view.panel)), {0, 0});
    page(frame);
    ImGui::EndChild();
}

void Panels::page(FrameContext& frame)
{
    lights_.mutes = true;
    cameras_.output_socket = "camera";
    skies_.output_socket = "sky";
    // They are parts of the scene, whatever group is open.
    std::optional<graph::AtRest> scene;
    if (frame.view.panel == Panel::lights || frame.view.panel == Panel::camera) scene.emplace(frame.draft.document);
    switch (frame.view.panel) {
        case Panel::materials: return draw_materials_panel(frame, materials_);
        case Panel::lights: return draw_lights_panel(frame, lights_);
        case Panel::camera: return draw_camera_panel(frame, cameras_, skies_);
        case Panel::cost: return draw_cost_panel(frame);
        case Panel::field: return draw_field_panel(frame);
        case Panel::stereo: return draw_stereo_panel(frame);
        case Panel::shader: return shader_.draw(frame);
        case Panel::problems: return draw_problems_panel(frame);
        case Panel::history: return draw_history_panel(frame);
    }
}

}  // namespace fieldwright::ui
