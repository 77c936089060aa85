// Hands on the plot of a curve.
#include "ui/curve_field.h"

#include "graph/curve.h"
#include "graph/known_types.h"
#include "ui/plot.h"
#include "ui/points_field.h"
#include "ui/widgets.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr int nothing = -1;

void sort(graph::PointList& points)
{
    std::stable_sort(points.begin(), points.end(), [](glm::vec4 a, glm::vec4 b) { return a.x < b.x; });
}

// All points and the unit square, with a margin.
Plot plot_of(const ImRect& box, const graph::PointList& points)
{
    Plot plot{box};
    for (const glm::vec4& point : points) {
        plot.low = glm::min(plot.low, glm::vec2(point));
        plot.high = glm::max(plot.high, glm::vec2(point));
    }
    glm::vec2 margin = 0.06f * (plot.high - plot.low);
    return {box, plot.low - margin, plot.high + margin};
}

// The plot's state between frames, of the ImGui window: the point in the hand, and what was shown when it was taken.
class Hand {
public:
    Hand() : storage_(*ImGui::GetStateStorage()) {}

    int point() const { return storage_.GetInt(ImGui::GetID("hand"), nothing); }
    void take(int point, const Plot& plot)
    {
        storage_.SetInt(ImGui::GetID("hand"), point);
        for (int i = 0; i < 4; ++i) storage_.SetFloat(edge(i), i < 2 ? plot.low[i] : plot.high[i - 2]);
    }
    void let_go() { storage_.SetInt(ImGui::GetID("hand"), nothing); }
    // While a point is in the hand, the axes stay.
    Plot steadied(Plot plot) const
    {
        if (point() == nothing) return plot;
        for (int i = 0; i < 4; ++i) (i < 2 ? plot.low[i] : plot.high[i - 2]) = storage_.GetFloat(edge(i));
        return plot;
    }

private:
    static ImGuiID edge(int i) { return ImGui::GetID(reinterpret_cast<void*>(static_cast<std::intptr_t>(i + 1))); }
    ImGuiStorage& storage_;
};

int nearest_point(const Plot& plot, const graph::PointList& points, ImVec2 mouse, float reach_px)
{
    int nearest = nothing;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ImVec2 at = plot.place(points[i]);
        float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
        if (distance > reach_px) continue;
        reach_px = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

// A point stays between its neighbours.
bool move_point(graph::PointList& points, int index, glm::vec2 to, const graph::Parameter& parameter)
{
    auto i = static_cast<std::size_t>(index);
    if (i >= points.size()) return false;
    auto low = static_cast<float>(parameter.minimum), high = static_cast<float>(parameter.maximum);
    float left = i > 0 ? points[i - 1].x : low, right = i + 1 < points.size() ? points[i + 1].x : high;
    glm::vec2 limited(std::clamp(to.x, left, std::max(left, right)), std::clamp(to.y, low, high));
    if (limited == glm::vec2(points[i])) return false;
    points[i].x = limited.x;
    points[i].y = limited.y;
    return true;
}

bool add_point(graph::PointList& points, glm::vec2 at)
{
    if (points.size() >= graph::curve_point_limit) return false;
    points.emplace_back(at, 0, 0);
    sort(points);
    return true;
}

bool remove_point(graph::PointList& points, int index)
{
    if (index == nothing || points.size() <= 1) return false;
    points.erase(points.begin() + index);
    return true;
}

// What the mouse does over the plot; the last item is the plot.
bool edit(const FrameContext& frame, const Plot& plot, const graph::Parameter& parameter, graph::PointList& points)
{
    Hand hand;
    ImVec2 mouse = ImGui::GetIO().MousePos;
    int near = ImGui::IsItemHovered() ? nearest_point(plot, points, mouse, frame.theme.px(9)) : nothing;
    if (ImGui::IsItemActivated() && near != nothing && ImGui::IsMouseClicked(0)) hand.take(near, plot);
    bool held = ImGui::IsItemActive() && hand.point() != nothing;
    if (held && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete), false)) {
        bool removed = remove_point(points, hand.point());
        hand.let_go();
        return removed;
    }
    if (held && ImGui::IsMouseDragging(0, frame.theme.px(2)))
        return move_point(points, hand.point(), plot.at(mouse), parameter);
    if (!ImGui::IsItemActive()) hand.let_go();
    if (near != nothing && ImGui::IsMouseClicked(1)) return remove_point(points, near);
    bool adds = ImGui::IsItemHovered() && near == nothing && ImGui::IsMouseDoubleClicked(0);
    return adds && add_point(points, plot.at(mouse));
}

void draw_curve(const FrameContext& frame, const Plot& plot, const graph::PointList& points, bool smooth)
{
    std::vector<glm::vec2> line;
    int count = std::max(static_cast<int>(plot.box.GetWidth() / 2), 2);
    for (int i = 0; i <= count; ++i) {
        float x = glm::mix(plot.low.x, plot.high.x, static_cast<float>(i) / static_cast<float>(count));
        line.emplace_back(x, graph::curve_at(points, smooth, x));
    }
    draw_line(frame.theme, plot, line, colour::text, 1.75f);
}

// Where on the curve the node is, when that is a number of its own.
void draw_place(const FrameContext& frame, const Plot& plot, const graph::Node& node, const graph::PointList& points,
                bool smooth)
{
    const graph::Value* value = node.parameter(graph::known_types::curve_place);
    const float* x = value && !node.input(graph::known_types::curve_place) ? std::get_if<float>(value) : nullptr;
    if (!x || *x < plot.low.x || *x > plot.high.x) return;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 at = plot.place({*x, graph::curve_at(points, smooth, *x)});
    ImU32 tint = colour::with_alpha(colour::quiet_text, 0.55f);
    draw.AddLine({at.x, plot.box.Min.y}, {at.x, plot.box.Max.y}, tint);
    draw.AddCircle(at, frame.theme.px(5), colour::quiet_text, 0, frame.theme.px(1.5f));
}

void draw_points(const FrameContext& frame, std::string_view path, const Plot& plot, const graph::PointList& points)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    float reach = frame.theme.px(7);
    int lit = Hand().point();
    if (lit == nothing && ImGui::IsItemHovered())
        lit = nearest_point(plot, points, ImGui::GetIO().MousePos, frame.theme.px(9));
    for (std::size_t i = 0; i < points.size(); ++i) {
        ImVec2 at = plot.place(points[i]);
        bool is_lit = static_cast<int>(i) == lit;
        draw.AddCircleFilled(at, frame.theme.px(is_lit ? 6 : 5), colour::window);
        draw.AddCircleFilled(at, frame.theme.px(is_lit ? 5 : 4), is_lit ? colour::accent : colour::text);
        frame.rects.mark(std::string(path) + "/curve/" + std::to_string(i),
                         {{at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}});
    }
}

}  // namespace

bool curve_field(FrameContext& frame, std::string_view path, const graph::Node& node, const graph::Parameter& parameter,
                 graph::PointList& points)
{
    const graph::Value* style = node.parameter(graph::known_types::curve_style);
    bool smooth = !style || *style == graph::Value(std::string("smooth"));
    ImGui::PushID("curve");
    sort(points);
    float left = grid_number_width(frame.theme), below = frame.theme.px(20);
    ImVec2 low = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x - left, frame.theme.px(170));
    low.x += left;
    ImGui::SetCursorScreenPos(low);
    Plot plot = Hand().steadied(plot_of({low, {low.x + size.x, low.y + size.y}}, points));
    ImGui::InvisibleButton("plot", size);
    frame.rects.mark(std::string(path) + "/curve");
    bool changed = edit(frame, plot, parameter, points);
    ImGui::PushClipRect(plot.box.Min, plot.box.Max, true);
    draw_grid(frame.theme, plot);
    draw_place(frame, plot, node, points, smooth);
    draw_curve(frame, plot, points, smooth);
    draw_points(frame, path, plot, points);
    ImGui::PopClipRect();
    draw_grid_numbers(frame.theme, plot);
    tooltip(frame, "Drag a point; double-click adds one, a right click takes one away.");
    ImGui::Dummy({0, below - ImGui::GetStyle().ItemSpacing.y});
    ImGui::PopID();
    return points_table(frame, path, parameter, points, PointOrder::by_place) || changed;
}

}  // namespace fieldwright::ui
