// The tabs, and the panel that the chosen one shows.
#include "ui/panels.h"

#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <iterator>

namespace fieldwright::ui {
namespace {

struct Tab {
    Panel panel;
    const char *name, *title, *icon, *tip;
};

constexpr Tab tabs[] = {
    {Panel::materials, "materials", "Materials", icon::palette, "Materials: what surfaces are made of"},
    {Panel::lights, "lights", "Lights", icon::bulb, "Lights"},
    {Panel::camera, "camera", "Camera", icon::camera, "Camera and sky"},
    {Panel::cost, "cost", "Cost", icon::gauge, "Cost: what the scene asks of the machine, and the steps heatmap"},
    {Panel::stereo, "stereo", "Stereo", icon::glasses, "Stereo: red-cyan pictures for two eyes"},
    {Panel::shader, "shader", "Shader", icon::code, "Shader: the live GLSL of the scene, and its export"},
    {Panel::problems, "problems", "Problems", icon::warning, "Problems of the scene"},
    {Panel::history, "history", "History", icon::history, "History: the steps that were made"},
};

std::string count_text(std::size_t count) { return count > 99 ? "99+" : std::to_string(count); }

ImVec2 badge_size(const FrameContext& frame, const std::string& text)
{
    float height = frame.theme.px(13);
    float width = frame.theme.fonts.small->CalcTextSizeA(frame.theme.px(10), FLT_MAX, 0, text.c_str()).x;
    return {std::max(width + frame.theme.px(7), height), height};
}

void badge(const FrameContext& frame, ImVec2 at, const std::string& text, ImU32 tint)
{
    ImFont* font = frame.theme.fonts.small;
    float font_px = frame.theme.px(10);
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

void tab(FrameContext& frame, const Tab& entry, float width_px, bool active)
{
    const Theme& theme = frame.theme;
    ImVec2 low = ImGui::GetCursorScreenPos(), size(width_px, theme.px(28));
    if (ImGui::InvisibleButton(entry.name, size)) frame.view.panel = entry.panel;
    frame.rects.mark(std::string("panel/tab/") + entry.name);
    bool hovered = ImGui::IsItemHovered();
    tooltip(frame, entry.tip);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 high(low.x + size.x, low.y + size.y);
    if (active || hovered)
        draw.AddRectFilled(low, high, active ? colour::field : colour::rgb(0x22262c), theme.px(4),
                           ImDrawFlags_RoundCornersTop);
    if (active) draw.AddRectFilled({low.x, high.y - theme.px(2)}, high, colour::accent);
    ImU32 tint = active || hovered ? colour::text : colour::quiet_text;
    ImVec2 glyph = ImGui::CalcTextSize(entry.icon);
    float y = low.y + std::floor(0.5f * (size.y - ImGui::GetFontSize()));
    float x = active ? low.x + theme.px(8) : low.x + std::floor(0.5f * (size.x - glyph.x));
    draw.AddText({x, y}, tint, entry.icon);
    if (active) draw.AddText({x + glyph.x + theme.px(6), y}, tint, entry.title);
    const auto& problems = frame.readings.problems;
    if (entry.panel != Panel::problems || problems.empty()) return;
    std::string count = count_text(problems.size());
    ImVec2 extent = badge_size(frame, count);
    // Behind the title, or at the upper right of the icon.
    ImVec2 at = active ? ImVec2(high.x - extent.x - theme.px(6), low.y + std::floor(0.5f * (size.y - extent.y)))
                       : ImVec2(std::min(x + glyph.x - theme.px(6), high.x - extent.x), low.y + theme.px(1));
    badge(frame, at, count, worst_tint(problems));
}

// An icon and a title; the count of the problems, too.
float active_width(const FrameContext& frame, const Tab& entry)
{
    float width = ImGui::CalcTextSize(entry.icon).x + ImGui::CalcTextSize(entry.title).x + frame.theme.px(22);
    std::size_t problems = frame.readings.problems.size();
    if (entry.panel == Panel::problems && problems)
        width += badge_size(frame, count_text(problems)).x + frame.theme.px(6);
    return width;
}

void tab_bar(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    const Tab& active = *std::find_if(std::begin(tabs), std::end(tabs) - 1,
                                      [&](const Tab& entry) { return entry.panel == frame.view.panel; });
    float room = ImGui::GetContentRegionAvail().x, count = static_cast<float>(std::size(tabs));
    float wide = active_width(frame, active);
    float width = std::min(std::floor((room - wide) / (count - 1)), theme.px(40));
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    for (const Tab& entry : tabs) {
        if (&entry != tabs) ImGui::SameLine();
        tab(frame, entry, &entry == &active ? wide : width, &entry == &active);
    }
    ImGui::PopStyleVar();
    float y = low.y + theme.px(28);
    ImGui::GetWindowDrawList()->AddLine({low.x, y}, {low.x + room, y}, colour::line);
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
    switch (frame.view.panel) {
        case Panel::materials: return draw_materials_panel(frame, materials_);
        case Panel::lights: return draw_lights_panel(frame, lights_);
        case Panel::camera: return draw_camera_panel(frame, cameras_, skies_);
        case Panel::cost: return draw_cost_panel(frame);
        case Panel::stereo: return draw_stereo_panel(frame);
        case Panel::shader: return shader_.draw(frame);
        case Panel::problems: return draw_problems_panel(frame);
        case Panel::history: return draw_history_panel(frame);
    }
}

}  // namespace fieldwright::ui
