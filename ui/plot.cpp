// Drawing a grid and lines over it.
#include "ui/plot.h"

#include "ui/number_text.h"

#include <cmath>
#include <string>
#include <vector>

namespace fieldwright::ui {
namespace {

constexpr ImU32 fine_line = colour::rgb(0x252a31);

// Visits the round numbers on an axis.
template <typename Visit>
void for_each_line(const Plot& plot, int axis, const Visit& visit)
{
    double low = static_cast<double>(plot.low[axis]), high = static_cast<double>(plot.high[axis]);
    double step = grid_step(high - low);
    for (double i = std::ceil(low / step); i * step <= high; ++i) visit(i * step);
}

void draw_number(const Theme& theme, const Plot& plot, int axis, double number)
{
    ImFont& font = *theme.fonts.small;
    std::string text = number_text(number, 0);
    ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e9f, 0, text.c_str());
    ImVec2 at = plot.place(glm::vec2(static_cast<float>(number)));
    if (axis == 0) at = {at.x - 0.5f * size.x, plot.box.Max.y + theme.px(2)};
    else at = {plot.box.Min.x - theme.px(6) - size.x, at.y - 0.5f * size.y};
    ImGui::GetWindowDrawList()->AddText(&font, font.FontSize, {std::floor(at.x), std::floor(at.y)}, colour::quiet_text,
                                        text.c_str());
}

}  // namespace

ImVec2 Plot::place(glm::vec2 at) const
{
    glm::vec2 share = (at - low) / (high - low);
    return {box.Min.x + share.x * box.GetWidth(), box.Max.y - share.y * box.GetHeight()};
}

glm::vec2 Plot::at(ImVec2 place_px) const
{
    glm::vec2 share((place_px.x - box.Min.x) / box.GetWidth(), (box.Max.y - place_px.y) / box.GetHeight());
    return low + share * (high - low);
}

double grid_step(double span)
{
    double power = std::pow(10.0, std::floor(std::log10(std::max(span, 1e-9) / 4)));
    for (double step : {5.0, 2.0})
        if (span / (step * power) >= 4) return step * power;
    return power;
}

void draw_grid(const Theme& theme, const Plot& plot)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(plot.box.Min, plot.box.Max, colour::window, theme.px(4));
    for (int axis : {0, 1})
        for_each_line(plot, axis, [&](double number) {
            ImVec2 at = plot.place(glm::vec2(static_cast<float>(number)));
            ImU32 tint = number == 0 ? colour::line : fine_line;
            float x = std::floor(at.x) + 0.5f, y = std::floor(at.y) + 0.5f;
            if (axis == 0) draw.AddLine({x, plot.box.Min.y}, {x, plot.box.Max.y}, tint);
            else draw.AddLine({plot.box.Min.x, y}, {plot.box.Max.x, y}, tint);
        });
}

void draw_grid_numbers(const Theme& theme, const Plot& plot)
{
    for (int axis : {0, 1}) for_each_line(plot, axis, [&](double number) { draw_number(theme, plot, axis, number); });
}

float grid_number_width(const Theme& theme) { return theme.px(34); }

void draw_line(const Theme& theme, const Plot& plot, std::span<const glm::vec2> points, ImU32 tint, float width)
{
    std::vector<ImVec2> places;
    places.reserve(points.size());
    for (glm::vec2 point : points) places.push_back(plot.place(point));
    ImGui::GetWindowDrawList()->AddPolyline(places.data(), static_cast<int>(places.size()), tint, 0, theme.px(width));
}

}  // namespace fieldwright::ui
