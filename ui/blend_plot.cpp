// Two plots over one axis, the stretch that is blended lit.
#include "ui/blend_plot.h"

#include "ui/number_text.h"
#include "ui/plot.h"
#include "ui/widgets.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr ImU32 a_tint = colour::rgb(0x7cab5e), b_tint = colour::rgb(0x5f8edb), result_tint = colour::rgb(0xe0a93e);

std::vector<glm::vec2> line_of(const BlendCurve& curve, const std::vector<float>& over)
{
    std::vector<glm::vec2> line;
    for (std::size_t i = 0; i < curve.across.size(); ++i) line.emplace_back(curve.across[i], over[i]);
    return line;
}

// A word in small letters at a place of the plot, moved by shares of its own size.
void label(const FrameContext& frame, ImVec2 at, glm::vec2 anchor, std::string_view word, ImU32 tint)
{
    ImFont& font = *frame.theme.fonts.small;
    ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e9f, 0, word.data(), word.data() + word.size());
    ImGui::GetWindowDrawList()->AddText(&font, font.FontSize,
                                        {std::floor(at.x - anchor.x * size.x), std::floor(at.y - anchor.y * size.y)},
                                        tint, word.data(), word.data() + word.size());
}

// The stretch in which both distances count.
void light_blend(const Plot& plot, float size)
{
    ImVec2 low = plot.place({-size, plot.high.y}), high = plot.place({size, plot.low.y});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, colour::with_alpha(result_tint, 0.09f));
    for (float x : {low.x, high.x}) draw.AddLine({x, low.y}, {x, high.y}, colour::with_alpha(result_tint, 0.35f));
}

Plot take_place(const FrameContext& frame, const char* id, float height_px, glm::vec2 low, glm::vec2 high)
{
    ImVec2 at = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, frame.theme.px(height_px));
    ImGui::InvisibleButton(id, size);
    return {{at, {at.x + size.x, at.y + size.y}}, low, high};
}

void distances(FrameContext& frame, const BlendCurve& curve, float reach)
{
    float least = 0, most = 0;
    for (const std::vector<float>* row : {&curve.a, &curve.b, &curve.result}) {
        least = std::min(least, *std::min_element(row->begin(), row->end()));
        most = std::max(most, *std::max_element(row->begin(), row->end()));
    }
    float margin = 0.08f * (most - least);
    Plot plot = take_place(frame, "distances", 120, {-reach, least - margin}, {reach, most + margin});
    ImGui::PushClipRect(plot.box.Min, plot.box.Max, true);
    draw_grid(frame.theme, plot);
    light_blend(plot, curve.size);
    draw_line(frame.theme, plot, line_of(curve, curve.a), a_tint);
    draw_line(frame.theme, plot, line_of(curve, curve.b), b_tint);
    draw_line(frame.theme, plot, line_of(curve, curve.result), result_tint, 2.25f);
    // Below the lines, but the result on the side that is free.
    std::size_t middle = curve.across.size() / 2, near_left = curve.across.size() / 12;
    std::size_t near_right = curve.across.size() - 1 - near_left;
    bool is_above = curve.result[middle] > curve.a[middle];
    label(frame, plot.place({curve.across[near_right], curve.a[near_right]}), {0.5f, -0.25f}, "a", a_tint);
    label(frame, plot.place({curve.across[near_left], curve.b[near_left]}), {0.5f, -0.25f}, curve.of_sum ? "−b" : "b",
          b_tint);
    label(frame, plot.place({0, curve.result[middle]}), {0.5f, is_above ? 1.2f : -0.2f}, "result", result_tint);
    ImGui::PopClipRect();
}

void slopes(FrameContext& frame, const BlendCurve& curve, float reach)
{
    Plot plot = take_place(frame, "slope", 56, {-reach, -1.3f}, {reach, 1.3f});
    ImGui::PushClipRect(plot.box.Min, plot.box.Max, true);
    draw_grid(frame.theme, plot);
    light_blend(plot, curve.size);
    draw_line(frame.theme, plot, line_of(curve, curve.slope), colour::text);
    label(frame, {plot.box.Min.x + frame.theme.px(6), plot.box.GetCenter().y}, {0, 0.5f}, "slope", colour::text);
    ImGui::PopClipRect();
}

// Under both: where the blend begins and ends.
void axis(const FrameContext& frame, const BlendCurve& curve, float reach)
{
    ImVec2 low = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = frame.theme.px(18);
    ImGui::Dummy({width, height});
    auto place = [&](float across) { return low.x + (across / reach * 0.5f + 0.5f) * width; };
    std::string size = number_text(static_cast<double>(curve.size), 2);
    label(frame, {place(-curve.size), low.y}, {0.5f, 0}, "−" + size, colour::quiet_text);
    label(frame, {place(curve.size), low.y}, {0.5f, 0}, size + " m", colour::quiet_text);
    label(frame, {place(0), low.y}, {0.5f, 0}, curve.of_sum ? "a + b" : "a − b", colour::quiet_text);
}

}  // namespace

void blend_plot(FrameContext& frame, std::string_view path, const BlendCurve& curve)
{
    if (curve.across.empty()) return;
    float reach = curve.across.back();
    section(frame, "Blend");
    ImGui::PushID("blend");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, frame.theme.px(2)));
    distances(frame, curve, reach);
    frame.rects.mark(path);
    tooltip(frame, "The two distances where they pass each other, and what is made of them.");
    slopes(frame, curve, reach);
    frame.rects.mark(std::string(path) + "/slope");
    tooltip(frame, "How the result changes: a jump here is an edge in the light, a bend is seen in reflections.");
    ImGui::PopStyleVar();
    axis(frame, curve, reach);
    ImGui::PopID();
}

}  // namespace fieldwright::ui
