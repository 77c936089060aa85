// Problems: what is wrong with the scene, and where.
#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

namespace fieldwright::ui {
namespace {

constexpr std::size_t most_rows = 200;

void problem_row(FrameContext& frame, const graph::Problem& problem, std::size_t index)
{
    const Theme& theme = frame.theme;
    bool error = problem.severity == graph::Problem::Severity::error;
    const graph::Node* node = frame.draft.document.root.find(problem.node);
    std::string title = node ? title_of(*node, frame.draft.library) : "Scene";
    ImVec2 low = ImGui::GetCursorScreenPos();
    float indent = theme.px(32), width = ImGui::GetContentRegionAvail().x,
          wrap = std::max(width - indent - theme.px(8), 40.0f);
    std::string sentence = as_sentence(problem.sentence);
    const char *begin = sentence.data(), *end = begin + sentence.size();
    float height = theme.row() + ImGui::CalcTextSize(begin, end, false, wrap).y + theme.px(6);
    ImGui::PushID(static_cast<int>(index));
    bool pressed = ImGui::InvisibleButton("problem", {width, height});
    ImGui::PopID();
    frame.rects.mark("panel/problems/" + std::to_string(index));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered())
        draw.AddRectFilled(low, {low.x + width, low.y + height}, colour::rgb(0x23282f), theme.px(4));
    float y = low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()));
    draw.AddText({low.x + theme.px(8), y}, error ? colour::error : colour::warning, error ? icon::error : icon::info);
    ImGui::PushFont(theme.fonts.heading);
    draw.AddText({low.x + indent, y}, colour::text, fitted(title, wrap).c_str());
    ImGui::PopFont();
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + indent, low.y + theme.row() - theme.px(2)},
                 colour::rgb(0xa9b2bf), begin, end, wrap);
    if (!pressed || !node) return;
    frame.view.selection.only(problem.node);
    frame.view.frame_request = problem.node;
}

}  // namespace

void draw_problems_panel(FrameContext& frame)
{
    const std::vector<graph::Problem>& problems = frame.readings.problems;
    if (problems.empty()) {
        empty_state(frame, icon::check, "No problems.");
        return;
    }
    for (std::size_t i = 0; i < std::min(problems.size(), most_rows); ++i) problem_row(frame, problems[i], i);
    if (problems.size() > most_rows) paragraph("And " + std::to_string(problems.size() - most_rows) + " more.");
}

}  // namespace fieldwright::ui
