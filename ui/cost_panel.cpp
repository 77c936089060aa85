// Cost: what the scene asks of the machine, and what the last picture took.
#include "ui/number_text.h"
#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

void scene_cost(FrameContext& frame)
{
    const graph::Program* program = frame.readings.program.get();
    std::int64_t cost = program ? program->expanded_cost : 0, limit = graph::LowerOptions{}.cost_limit;
    float share = static_cast<float>(cost) / static_cast<float>(limit);
    section(frame, "Scene");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.theme.padding(), 0));
    fact_row(frame, "Cost", grouped_text(cost) + " of " + grouped_text(limit),
             "Primitives that one look at the field evaluates, copies of repetitions included. A scene above the limit "
             "is not drawn.");
    to_field_column(frame);
    share_bar(frame, share, share > 1 ? colour::error : share > 0.75f ? colour::warning : colour::rgb(0x6f89a8));
    frame.rects.mark("panel/cost/bar");
    ImGui::Dummy({0, frame.theme.gap()});
    fact_row(frame, "Nodes", grouped_text(static_cast<std::int64_t>(frame.draft.document.root.nodes.size())));
    if (program)
        fact_row(frame, "Step budget", grouped_text(program->step_budget) + " steps per pixel",
                 "Steps that all rays of a pixel may take together; loops in the scene make it smaller.");
    ImGui::PopStyleVar();
}

void picture_cost(FrameContext& frame)
{
    const PictureReading& picture = frame.readings.picture;
    section(frame, "Last picture");
    if (picture.width == 0) {
        paragraph("No picture has been drawn yet.");
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.theme.padding(), 0));
    fact_row(frame, "Draw time", duration_text(picture.draw_ms));
    fact_row(frame, "Size", std::to_string(picture.width) + " × " + std::to_string(picture.height) + " px");
    fact_row(frame, "Mean steps", rounded_text(picture.mean_steps), "Of the rays from the eye.");
    fact_row(frame, "Most steps",
             grouped_text(picture.max_steps) + " of " + grouped_text(frame.draft.document.march.step_limit));
    fact_row(frame, "Out of steps", percent_text(picture.exhausted_share) + " of pixels",
             "Rays that reached the step limit before a surface. Raise the limit in the scene's settings, or look at "
             "the heatmap for where it happens.");
    if (!picture.device.empty()) fact_row(frame, "Drawn by", picture.device);
    ImGui::PopStyleVar();
}

// Viridis (S. van der Walt and N. Smith, 2015) at nine even places, sRGB.
constexpr ImU32 viridis[] = {colour::rgb(0x440154), colour::rgb(0x472d7b), colour::rgb(0x3b528b),
                             colour::rgb(0x2c728e), colour::rgb(0x21918c), colour::rgb(0x28ae80),
                             colour::rgb(0x5ec962), colour::rgb(0xaddc30), colour::rgb(0xfde725)};

void legend(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    to_field_column(frame);
    ImVec2 low = ImGui::GetCursorScreenPos(), size(row_field_width(frame), theme.px(10));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    constexpr int parts = static_cast<int>(std::size(viridis)) - 1;
    for (int i = 0; i < parts; ++i) {
        float from = low.x + size.x * static_cast<float>(i) / parts,
              to = low.x + size.x * static_cast<float>(i + 1) / parts;
        draw.AddRectFilledMultiColor({from, low.y}, {to, low.y + size.y}, viridis[i], viridis[i + 1], viridis[i + 1],
                                     viridis[i]);
    }
    ImGui::PushFont(theme.fonts.small);
    int limit = frame.draft.document.march.step_limit;
    std::string middle = std::to_string(limit / 2), end = std::to_string(limit) + " steps";
    float y = low.y + size.y + theme.px(2);
    draw.AddText({low.x, y}, colour::quiet_text, "0");
    draw.AddText({low.x + 0.5f * (size.x - ImGui::CalcTextSize(middle.c_str()).x), y}, colour::quiet_text,
                 middle.c_str());
    draw.AddText({low.x + size.x - ImGui::CalcTextSize(end.c_str()).x, y}, colour::quiet_text, end.c_str());
    ImGui::Dummy({size.x, size.y + theme.px(2) + ImGui::GetFontSize()});
    ImGui::PopFont();
    frame.rects.mark("panel/cost/legend");
}

}  // namespace

void draw_cost_panel(FrameContext& frame)
{
    bool heatmap = frame.view.view == "steps";
    begin_row(frame, "Steps heatmap", "Shows how many steps the ray of each pixel took.");
    if (toggle(frame, "heatmap", heatmap)) frame.view.view = heatmap ? "steps" : "beauty";
    frame.rects.mark("panel/cost/heatmap");
    if (heatmap) legend(frame);
    scene_cost(frame);
    picture_cost(frame);
}

}  // namespace fieldwright::ui
