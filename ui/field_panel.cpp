// Field: the plane on which distances are shown, and the way of one ray.
#include "graph/slice_plane.h"
#include "ui/choice_field.h"
#include "ui/framing.h"
#include "ui/number_field.h"
#include "ui/number_text.h"
#include "ui/panel_pages.h"
#include "ui/plot.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fieldwright::ui {
namespace {

constexpr float plot_height_px = 120;

// The slice shows what there is, from the middle of it.
void frame_slice(FrameContext& frame)
{
    SliceView& slice = frame.view.slice;
    Measured box = box_to_frame(frame, {});
    const graph::SlicePlane* plane = graph::find_slice_plane(slice.plane);
    if (!plane) {
        float length = frame.readings.ray ? frame.readings.ray->t_end : 4;
        slice.centre = {0.5f * length, 0};
        slice.height = std::max(0.6f * length, 0.1f);
        return;
    }
    glm::vec3 half = glm::abs(box.half_size);
    slice.centre = {glm::dot(box.centre, plane->right), glm::dot(box.centre, plane->up)};
    float up = glm::dot(half, glm::abs(plane->up)), right = glm::dot(half, glm::abs(plane->right));
    slice.height = std::clamp(2.6f * std::max(up, 0.6f * right), 0.01f, 1000.0f);
}

void plane_rows(FrameContext& frame)
{
    SliceView& slice = frame.view.slice;
    begin_row(frame, "Plane", "The two axes that span it, or the plane through the ray that is inspected.");
    std::vector<std::pair<std::string, std::string>> planes;
    for (const graph::SlicePlane& plane : graph::slice_planes) planes.emplace_back(plane.name, plane.name);
    if (frame.readings.ray) planes.emplace_back("ray", "Ray");
    std::string before = slice.plane;
    if (segments(frame, "panel/field/plane", planes, slice.plane) && (before == "ray" || slice.plane == "ray"))
        frame_slice(frame);
    if (slice.plane == "ray") return;
    NumberStyle style{.soft_minimum = -5,
                      .soft_maximum = 5,
                      .unit = "m",
                      .fill = false,
                      .tip = "Where the plane cuts its third axis."};
    double offset = slice.offset;
    style.width_px = begin_row(frame, "Offset", style.tip);
    if (number_field(frame, "##offset", "Offset", offset, style)) slice.offset = static_cast<float>(offset);
    frame.rects.mark("panel/field/offset");
}

void style_rows(FrameContext& frame)
{
    SliceView& slice = frame.view.slice;
    float width = begin_row(frame, "Style", "What is shown of the distances.");
    choice_field(frame, "panel/field/style", width, frame.readings.slice_styles, slice.style);
    if (const Choice* style = find_choice(frame.readings.slice_styles, slice.style)) {
        to_field_column(frame);
        paragraph(style->help);
    }
    if (slice.style == "sign")
        fact_row(frame, "Lines", "every " + rounded_text(graph::line_spacing(slice.height)) + " m");
    if (slice.style != "grey") return;
    NumberStyle number{.minimum = 0.2,
                       .maximum = 5,
                       .soft_minimum = 1,
                       .soft_maximum = 3,
                       .tip = "Larger shows small distances brighter."};
    double gamma = slice.gamma;
    number.width_px = begin_row(frame, "Gamma", number.tip);
    if (number_field(frame, "##gamma", "Gamma", gamma, number)) slice.gamma = static_cast<float>(gamma);
    frame.rects.mark("panel/field/gamma");
}

void slice_section(FrameContext& frame)
{
    bool shown = frame.view.view == "slice";
    begin_row(frame, "Distance slice", "Shows the field on a plane instead of the picture.");
    if (toggle(frame, "slice", shown)) {
        frame.view.view = shown ? "slice" : "beauty";
        if (shown) frame_slice(frame);
    }
    frame.rects.mark("panel/field/slice");
    if (!shown) return;
    plane_rows(frame);
    style_rows(frame);
    to_field_column(frame);
    if (text_button(frame, "frame", "Frame the scene")) frame_slice(frame);
    frame.rects.mark("panel/field/frame");
}

std::string end_text(const RayReading& ray)
{
    std::string steps = " after " + grouped_text(static_cast<std::int64_t>(ray.steps.size())) + " steps";
    if (ray.end == RayReading::End::hit) return "Hit" + steps + ", at " + rounded_text(ray.t_end) + " m";
    if (ray.end == RayReading::End::missed) return "Nothing hit" + steps;
    return "Out of steps" + steps + ", at " + rounded_text(ray.t_end) + " m";
}

std::string vector_text(glm::vec3 v)
{
    char text[80];
    std::snprintf(text, sizeof text, "%.3f  %.3f  %.3f", static_cast<double>(v.x), static_cast<double>(v.y),
                  static_cast<double>(v.z));
    return text;
}

float exponent(float distance) { return std::log10(std::max(std::abs(distance), 1e-6f)); }

// Distances by step, as powers of ten: a straight line down converges.
void convergence_plot(FrameContext& frame, const RayReading& ray)
{
    const Theme& theme = frame.theme;
    paragraph("Distance at each step, m as powers of ten:");
    std::vector<glm::vec2> points;
    glm::vec2 range(0);
    for (const RayReading::Step& step : ray.steps) {
        float y = exponent(step.distance);
        points.emplace_back(static_cast<float>(points.size() + 1), y);
        range = {std::min(range.x, std::floor(y)), std::max(range.y, std::ceil(y))};
    }
    ImVec2 low = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, theme.px(plot_height_px));
    float left = grid_number_width(theme), below = theme.px(18);
    Plot plot{.box = {{low.x + left, low.y + theme.px(4)}, {low.x + size.x - theme.px(8), low.y + size.y - below}},
              .low = {0, range.x},
              .high = {std::max(static_cast<float>(points.size()), 4.0f), std::max(range.y, range.x + 1)}};
    ImGui::Dummy(size);
    frame.rects.mark("panel/field/plot");
    draw_grid(theme, plot);
    draw_grid_numbers(theme, plot);
    draw_line(theme, plot, points, colour::axes[2], 1.5f);
    if (points.size() > 60) return;
    for (glm::vec2 point : points)
        ImGui::GetWindowDrawList()->AddCircleFilled(plot.place(point), theme.px(2), colour::text);
}

void number_cell(const FrameContext& frame, const char* format, double number)
{
    char text[32];
    std::snprintf(text, sizeof text, format, number);
    ImGui::TableNextColumn();
    float room = ImGui::GetContentRegionAvail().x, width = ImGui::CalcTextSize(text).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room - width - frame.theme.px(4), 0.0f));
    ImGui::TextUnformatted(text);
}

void heading_cell(const FrameContext& frame, const char* text)
{
    ImGui::TableNextColumn();
    float room = ImGui::GetContentRegionAvail().x, width = ImGui::CalcTextSize(text).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room - width - frame.theme.px(4), 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::quiet_text);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

void steps_table(FrameContext& frame, const RayReading& ray)
{
    if (!ImGui::BeginTable("steps", 4, ImGuiTableFlags_SizingStretchProp)) return;
    for (float share : {0.6f, 1.0f, 1.0f, 1.0f}) ImGui::TableSetupColumn("", 0, share);
    ImGui::PushFont(frame.theme.fonts.small);
    ImGui::TableNextRow();
    for (const char* heading : {"Step", "Way, m", "Distance, m", "Cone ratio"}) heading_cell(frame, heading);
    ImGui::PopFont();
    ImGui::PushFont(frame.theme.fonts.mono);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(ray.steps.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const RayReading::Step& step = ray.steps[static_cast<std::size_t>(i)];
            ImGui::TableNextRow();
            number_cell(frame, "%.0f", i + 1);
            number_cell(frame, "%.4f", static_cast<double>(step.t));
            number_cell(frame, "%.6f", static_cast<double>(step.distance));
            number_cell(frame, "%.5f", static_cast<double>(step.cone_ratio));
        }
    ImGui::PopFont();
    ImGui::EndTable();
    frame.rects.mark("panel/field/steps");
}

void ray_section(FrameContext& frame)
{
    section(frame, "Ray");
    bool inspecting = frame.view.click == Click::inspect;
    if (text_button(frame, "inspect", inspecting ? "Click on the picture…" : "Inspect a ray", 0,
                    inspecting ? colour::accent : colour::text))
        frame.view.click = inspecting ? Click::select : Click::inspect;
    frame.rects.mark("panel/field/inspect");
    if (!frame.readings.ray) {
        paragraph("Click on the picture, and every step of the ray that goes there is listed here.");
        return;
    }
    const RayReading& ray = *frame.readings.ray;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.theme.padding(), 0));
    fact_row(frame, "Outcome", end_text(ray));
    fact_row(frame, "From", vector_text(ray.origin), "Where it begins, m.");
    fact_row(frame, "Direction", vector_text(ray.direction));
    ImGui::PopStyleVar();
    to_field_column(frame);
    if (text_button(frame, "show", "Show it on the slice")) {
        frame.view.view = "slice";
        frame.view.slice.plane = "ray";
        frame_slice(frame);
    }
    frame.rects.mark("panel/field/show_ray");
    convergence_plot(frame, ray);
    steps_table(frame, ray);
}

}  // namespace

void draw_field_panel(FrameContext& frame)
{
    slice_section(frame);
    ray_section(frame);
}

}  // namespace fieldwright::ui
