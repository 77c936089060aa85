// The picture and the table of a list of points.
#include "ui/points_field.h"

#include "ui/number_field.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr std::size_t most_points = 4096;  // graph::value_error refuses more

// Where the plane of the points lies in the picture.
struct Plot {
    ImRect box;
    glm::vec2 centre{0, 0};  // m
    float px_per_m = 1;

    ImVec2 place(glm::vec4 point) const
    {
        ImVec2 middle = box.GetCenter();
        return {middle.x + (point.x - centre.x) * px_per_m, middle.y - (point.y - centre.y) * px_per_m};
    }
};

Plot make_plot(const ImRect& box, const graph::PointList& points, float margin_px)
{
    glm::vec2 low(1e9f), high(-1e9f);
    for (const glm::vec4& point : points) {
        low = glm::min(low, glm::vec2(point.x, point.y));
        high = glm::max(high, glm::vec2(point.x, point.y));
    }
    if (points.empty()) low = high = glm::vec2(0);
    glm::vec2 size = glm::max(high - low, glm::vec2(0.1f));
    float room = std::min((box.GetWidth() - 2 * margin_px) / size.x, (box.GetHeight() - 2 * margin_px) / size.y);
    return {box, 0.5f * (low + high), std::max(room, 1e-6f)};
}

void draw_plot(const FrameContext& frame, const Plot& plot, const graph::PointList& points)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(plot.box.Min, plot.box.Max, colour::window, frame.theme.px(4));
    ImVec2 origin = plot.place({0, 0, 0, 0});
    draw.AddLine({plot.box.Min.x, origin.y}, {plot.box.Max.x, origin.y}, colour::line);
    draw.AddLine({origin.x, plot.box.Min.y}, {origin.x, plot.box.Max.y}, colour::line);
    std::vector<ImVec2> line;
    for (const glm::vec4& point : points) line.push_back(plot.place(point));
    draw.AddPolyline(line.data(), static_cast<int>(line.size()), colour::text, 0, frame.theme.px(1.5f));
}

// While a point is in the hand, the picture stays as it was when the point was picked up.
Plot held_plot(Plot plot)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    auto keep = [&](const char* name, float& number, bool held) {
        if (held) number = storage.GetFloat(ImGui::GetID(name), number);
        else storage.SetFloat(ImGui::GetID(name), number);
    };
    ImGuiID active = ImGui::GetActiveID();
    bool held = active && active == static_cast<ImGuiID>(storage.GetInt(ImGui::GetID("held"), 0));
    keep("x", plot.centre.x, held);
    keep("y", plot.centre.y, held);
    keep("scale", plot.px_per_m, held);
    return plot;
}

bool picture(FrameContext& frame, std::string_view path, const graph::Parameter& parameter, graph::PointList& points)
{
    ImVec2 low = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, frame.theme.px(120));
    Plot plot = held_plot(make_plot({low, {low.x + size.x, low.y + size.y}}, points, frame.theme.px(16)));
    ImGui::Dummy(size);
    ImGui::PushClipRect(plot.box.Min, plot.box.Max, true);
    draw_plot(frame, plot, points);
    ImVec2 next = ImGui::GetCursorScreenPos();
    float grip = frame.theme.px(7);
    bool changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ImVec2 at = plot.place(points[i]);
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetCursorScreenPos({at.x - grip, at.y - grip});
        ImGui::InvisibleButton("grip", {2 * grip, 2 * grip});
        frame.rects.mark(std::string(path) + "/picture/" + std::to_string(i));
        bool in_hand = ImGui::IsItemActive(), lit = in_hand || ImGui::IsItemHovered();
        ImVec2 delta = ImGui::GetIO().MouseDelta;
        ImGui::GetWindowDrawList()->AddCircleFilled(at, frame.theme.px(lit ? 5 : 4),
                                                    lit ? colour::accent : colour::text);
        ImGui::PopID();
        if (!in_hand) continue;
        ImGui::GetStateStorage()->SetInt(ImGui::GetID("held"), static_cast<int>(ImGui::GetActiveID()));
        if (delta.x == 0 && delta.y == 0) continue;
        auto limit = [&](float v) {
            return std::clamp(v, static_cast<float>(parameter.minimum), static_cast<float>(parameter.maximum));
        };
        points[i].x = limit(points[i].x + delta.x / plot.px_per_m);
        points[i].y = limit(points[i].y - delta.y / plot.px_per_m);
        changed = true;
    }
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos(next);
    return changed;
}

// The next point continues the last two.
glm::vec4 following_point(const graph::PointList& points, const graph::Parameter& parameter)
{
    if (points.empty()) return {0, 0, 0, 0};
    glm::vec4 step = points.size() > 1 ? points.back() - points[points.size() - 2] : glm::vec4(0.25f, 0, 0, 0);
    return glm::clamp(points.back() + step, glm::vec4(static_cast<float>(parameter.minimum)),
                      glm::vec4(static_cast<float>(parameter.maximum)));
}

// What a row of the table asks for, done after the table is drawn.
struct Wish {
    enum class Kind { none, remove, swap_with_next } kind = Kind::none;
    std::size_t index = 0;
};

void swap_buttons(FrameContext& frame, const std::string& path, std::size_t index, std::size_t count, Wish& wish)
{
    ImGui::BeginDisabled(index == 0);
    if (icon_button(frame, "up", icon::arrow_up, "Move up")) wish = {Wish::Kind::swap_with_next, index - 1};
    ImGui::EndDisabled();
    frame.rects.mark(path + "/up");
    ImGui::SameLine(0, 0);
    ImGui::BeginDisabled(index + 1 == count);
    if (icon_button(frame, "down", icon::arrow_down, "Move down")) wish = {Wish::Kind::swap_with_next, index};
    ImGui::EndDisabled();
    frame.rects.mark(path + "/down");
    ImGui::SameLine(0, 0);
}

bool point_row(FrameContext& frame, const std::string& path, std::size_t index, const graph::Parameter& parameter,
               graph::PointList& points, PointOrder order, Wish& wish)
{
    const Theme& theme = frame.theme;
    float number_width = theme.px(24);
    ImGui::PushStyleColor(ImGuiCol_Text, colour::quiet_text);
    std::string number = std::to_string(index + 1);
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({number_width, theme.row()});
    ImGui::GetWindowDrawList()->AddText({low.x + number_width - theme.px(8) - ImGui::CalcTextSize(number.c_str()).x,
                                         low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()))},
                                        colour::quiet_text, number.c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(0, 0);
    NumberStyle style = number_style(parameter);
    style.soft_minimum = -1e6, style.soft_maximum = 1e6;
    float buttons = order == PointOrder::free ? 3 : 1;
    style.width_px = std::max(ImGui::GetContentRegionAvail().x - buttons * theme.row() - theme.gap(), theme.px(90));
    bool changed = vector_field(frame, path, "Point " + number, &points[index].x, 2, style);
    ImGui::SameLine(0, theme.gap());
    if (order == PointOrder::free) swap_buttons(frame, path, index, points.size(), wish);
    if (icon_button(frame, "delete", icon::trash, "Delete this point")) wish = {Wish::Kind::remove, index};
    frame.rects.mark(path + "/delete");
    return changed;
}

bool fulfil(const Wish& wish, graph::PointList& points)
{
    if (wish.kind == Wish::Kind::none) return false;
    auto place = points.begin() + static_cast<std::ptrdiff_t>(wish.index);
    if (wish.kind == Wish::Kind::remove) points.erase(place);
    else std::iter_swap(place, place + 1);
    return true;
}

}  // namespace

bool points_table(FrameContext& frame, std::string_view path, const graph::Parameter& parameter,
                  graph::PointList& points, PointOrder order)
{
    ImGui::PushID("points");
    bool changed = false;
    Wish wish;
    // Only the rows in view: a list may hold thousands.
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(points.size()), frame.theme.row() + frame.theme.gap());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::PushID(i);
            changed |= point_row(frame, std::string(path) + "/" + std::to_string(i), static_cast<std::size_t>(i),
                                 parameter, points, order, wish);
            ImGui::PopID();
        }
    changed |= fulfil(wish, points);
    ImGui::Dummy({frame.theme.px(24), 0});
    ImGui::SameLine(0, 0);
    ImGui::BeginDisabled(points.size() >= most_points);
    if (text_button(frame, "add", std::string(icon::add) + "  Add point")) {
        points.push_back(following_point(points, parameter));
        changed = true;
    }
    ImGui::EndDisabled();
    frame.rects.mark(std::string(path) + "/add");
    ImGui::PopID();
    return changed;
}

bool points_field(FrameContext& frame, std::string_view path, const graph::Parameter& parameter,
                  graph::PointList& points)
{
    ImGui::PushID("picture");
    bool changed = picture(frame, path, parameter, points);
    ImGui::PopID();
    return points_table(frame, path, parameter, points, PointOrder::free) || changed;
}

}  // namespace fieldwright::ui
