// History: the named steps, the present one marked; a click jumps.
#include "ui/commands.h"
#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

namespace fieldwright::ui {
namespace {

void step_row(FrameContext& frame, std::size_t index)
{
    const Theme& theme = frame.theme;
    const Readings& readings = frame.readings;
    bool present = index == readings.step, undone = index > readings.step;
    ImVec2 low = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(static_cast<int>(index));
    bool pressed = ImGui::InvisibleButton("step", {width, theme.row()});
    ImGui::PopID();
    frame.rects.mark("panel/history/" + std::to_string(index));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (present || ImGui::IsItemHovered())
        draw.AddRectFilled(low, {low.x + width, low.y + theme.row()},
                           present ? colour::rgb(0x2c3540) : colour::rgb(0x23282f), theme.px(4));
    ImVec2 dot(low.x + theme.px(14), low.y + 0.5f * theme.row());
    if (present) draw.AddCircleFilled(dot, theme.px(4), colour::accent);
    else draw.AddCircle(dot, theme.px(3), undone ? colour::line : colour::quiet_text);
    std::string shown = fitted(as_sentence(readings.step_names[index]), width - theme.px(36));
    draw.AddText({low.x + theme.px(28), low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()))},
                 undone ? colour::quiet_text : colour::text, shown.c_str());
    if (pressed && !present) frame.requests.push_back(JumpTo{index});
}

// The present step stays in view when it changes.
void follow(const FrameContext& frame)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    ImGuiID key = ImGui::GetID("followed");
    int step = static_cast<int>(frame.readings.step);
    if (storage.GetInt(key, -1) == step) return;
    storage.SetInt(key, step);
    float middle = (static_cast<float>(step) + 0.5f) * frame.theme.row();
    ImGui::SetScrollFromPosY(ImGui::GetCursorStartPos().y + middle - ImGui::GetScrollY(), 0.5f);
}

}  // namespace

void draw_history_panel(FrameContext& frame)
{
    const Readings& readings = frame.readings;
    ImGui::BeginDisabled(readings.step == 0);
    if (text_button(frame, "undo", std::string(icon::undo) + "  Undo")) frame.requests.push_back(Undo{});
    tooltip(frame, with_shortcut("Go one step back", "edit.undo"));
    ImGui::EndDisabled();
    frame.rects.mark("panel/history/undo");
    ImGui::SameLine(0, frame.theme.gap());
    ImGui::BeginDisabled(readings.step + 1 >= readings.step_names.size());
    if (text_button(frame, "redo", std::string(icon::redo) + "  Redo")) frame.requests.push_back(Redo{});
    tooltip(frame, with_shortcut("Do the next step again", "edit.redo"));
    ImGui::EndDisabled();
    frame.rects.mark("panel/history/redo");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGui::BeginChild("steps", {0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(readings.step_names.size()), frame.theme.row());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) step_row(frame, static_cast<std::size_t>(i));
    follow(frame);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace fieldwright::ui
