// Cost: what the scene asks of the machine, and what the last picture took.
#include "ui/choice_field.h"
#include "ui/legend.h"
#include "ui/number_field.h"
#include "ui/number_text.h"
#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>

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

void evaluation_rows(FrameContext& frame, const PictureReading& picture)
{
    if (picture.evaluations == 0) return;
    double each_ps = 1e9 * static_cast<double>(picture.draw_ms) / picture.evaluations;
    fact_row(frame, "Evaluations", grouped_text(static_cast<std::int64_t>(picture.evaluations)),
             "Of the whole field, by all rays: steps, normals, occlusion and shadows.");
    fact_row(frame, "Each takes", rounded_text(each_ps) + " ps",
             "Draw time by evaluations: with all cores at work, less than one of them needs.");
    std::int64_t primitives = frame.readings.program ? frame.readings.program->expanded_cost : 0;
    if (primitives > 1)
        fact_row(frame, "Per primitive", rounded_text(each_ps / static_cast<double>(primitives)) + " ps");
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
    fact_row(frame, "99 of 100 rays", "at most " + grouped_text(picture.p99_steps) + " steps");
    fact_row(frame, "Most steps",
             grouped_text(picture.max_steps) + " of " + grouped_text(frame.draft.document.march.step_limit));
    fact_row(frame, "Out of steps", percent_text(picture.exhausted_share) + " of pixels",
             "Rays that reached the step limit before a surface. Raise the limit in the scene's settings, or look at "
             "the heatmap for where it happens.");
    evaluation_rows(frame, picture);
    if (!picture.device.empty()) fact_row(frame, "Drawn by", picture.device);
    ImGui::PopStyleVar();
}

// The steps of the picture as a small one, so that they are seen beside it.
void side_picture(FrameContext& frame)
{
    const StepsPicture& steps = frame.readings.steps_picture;
    if (!steps.texture || steps.width == 0) return;
    float width = ImGui::GetContentRegionAvail().x;
    float height =
        std::min(width * static_cast<float>(steps.height) / static_cast<float>(steps.width), frame.theme.px(220));
    width = height * static_cast<float>(steps.width) / static_cast<float>(steps.height);
    ImVec2 low = ImGui::GetCursorScreenPos();
    low.x += std::floor(0.5f * (ImGui::GetContentRegionAvail().x - width));
    ImGui::GetWindowDrawList()->AddImageRounded(steps.texture, low, {low.x + width, low.y + height}, {0, 0}, {1, 1},
                                                IM_COL32_WHITE, frame.theme.px(4));
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, height});
    frame.rects.mark("panel/cost/side_picture", {{low.x, low.y}, {low.x + width, low.y + height}});
}

// Of the steps, whether they are the picture or stand beside it.
void legend(FrameContext& frame)
{
    std::optional<Legend> steps = legend_of(frame, "steps");
    if (!steps) return;
    begin_row(frame, "Steps", "Of the rays from the eye. Magenta: out of steps.");
    float width = row_field_width(frame);
    ImVec2 low = ImGui::GetCursorScreenPos();
    float height = draw_legend_bar(frame, *ImGui::GetWindowDrawList(), low, width, *steps);
    ImGui::Dummy({width, height});
    frame.rects.mark("panel/cost/legend");
}

void heatmap_rows(FrameContext& frame)
{
    ViewState& view = frame.view;
    bool heatmap = view.view == "steps", glow = view.view == "glow";
    begin_row(frame, "Steps heatmap", "Shows how many steps the ray of each pixel took.");
    if (toggle(frame, "heatmap", heatmap)) view.view = heatmap ? "steps" : "beauty";
    frame.rects.mark("panel/cost/heatmap");
    begin_row(frame, "Glow", "Shows the picture, and a magenta light over it where rays took many steps.");
    if (toggle(frame, "glow", glow)) view.view = glow ? "glow" : "beauty";
    frame.rects.mark("panel/cost/glow");
    float width =
        begin_row(frame, "Colour map", "Of heatmaps. Viridis and cividis are read without colour vision, too.");
    choice_field(frame, "panel/cost/colour_map", width, frame.readings.colour_maps, view.colour_map);
    NumberStyle scale{.minimum = 0,
                      .maximum = 60000,
                      .soft_minimum = 0,
                      .soft_maximum = 512,
                      .whole = true,
                      .at_zero = "Step limit",
                      .tip = "Steps at the end of the colours, and of the full glow; 0 is the step limit."};
    double steps = view.full_scale;
    scale.width_px = begin_row(frame, "Full scale", scale.tip);
    if (number_field(frame, "##full_scale", "Full scale", steps, scale)) view.full_scale = static_cast<int>(steps);
    frame.rects.mark("panel/cost/full_scale");
    if (!heatmap) side_picture(frame);
    legend(frame);
}

struct CostRow {
    graph::NodeId node;
    double ms;
};

std::vector<CostRow> dearest_first(const NodeCosts& costs, const graph::Graph& graph)
{
    std::vector<CostRow> rows;
    for (const auto& [node, ms] : costs.by_node)
        if (graph.find(node)) rows.push_back({node, ms});
    std::stable_sort(rows.begin(), rows.end(), [](const CostRow& a, const CostRow& b) { return a.ms > b.ms; });
    return rows;
}

void node_row(FrameContext& frame, const CostRow& row, double whole_ms)
{
    const Theme& theme = frame.theme;
    const graph::Node& node = *frame.draft.document.root.find(row.node);
    ImVec2 low = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, theme.row());
    ImGui::PushID(static_cast<int>(row.node.number));
    bool pressed = ImGui::InvisibleButton("node", size);
    ImGui::PopID();
    frame.rects.mark("panel/cost/node/" + std::to_string(row.node.number));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    float share = static_cast<float>(std::clamp(row.ms / std::max(whole_ms, 1e-9), 0.0, 1.0));
    float bar = theme.px(3), y = low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()));
    if (ImGui::IsItemHovered())
        draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, colour::rgb(0x23282f), theme.px(4));
    draw.AddRectFilled({low.x, low.y + size.y - bar}, {low.x + share * size.x, low.y + size.y - theme.px(1)},
                       colour::rgb(0x6f89a8), theme.px(1));
    std::string cost = duration_text(row.ms);
    float width = ImGui::CalcTextSize(cost.c_str()).x;
    draw.AddText({low.x + theme.px(4), y}, colour::text,
                 fitted(title_of(node, frame.draft.library), size.x - width - theme.px(24)).c_str());
    draw.AddText({low.x + size.x - width - theme.px(4), y}, colour::quiet_text, cost.c_str());
    if (!pressed) return;
    frame.view.selection.only(row.node);
    frame.view.frame_request = row.node;
}

void node_costs(FrameContext& frame)
{
    section(frame, "Time by node");
    const NodeCosts& costs = frame.readings.node_costs;
    ImGui::BeginDisabled(costs.measuring);
    if (text_button(frame, "measure", costs.measuring ? "Measuring…" : "Measure nodes"))
        frame.requests.push_back(MeasureNodes{});
    ImGui::EndDisabled();
    frame.rects.mark("panel/cost/measure");
    if (costs.measuring) return share_bar(frame, costs.progress, colour::rgb(0x6f89a8));
    if (!costs.failure.empty()) return paragraph(costs.failure, colour::warning);
    if (costs.picture_ms == 0) {
        paragraph("Draws the picture without each node in turn, on the CPU, and shows what it takes less.");
        return;
    }
    ImGui::SameLine(0, frame.theme.gap());
    begin_row(frame, "On the nodes", "Shows the times on the canvas, too.");
    toggle(frame, "on_nodes", frame.view.node_costs);
    frame.rects.mark("panel/cost/on_nodes");
    fact_row(frame, "Whole picture", duration_text(costs.picture_ms) + " on the CPU");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    for (const CostRow& row : dearest_first(costs, frame.draft.document.root)) node_row(frame, row, costs.picture_ms);
    ImGui::PopStyleVar();
}

}  // namespace

void draw_cost_panel(FrameContext& frame)
{
    heatmap_rows(frame);
    scene_cost(frame);
    picture_cost(frame);
    node_costs(frame);
}

}  // namespace fieldwright::ui
