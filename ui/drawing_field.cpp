// Painting on a drawing's canvas.
#include "ui/drawing_field.h"

#include "graph/words.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

using graph::Drawing;

const graph::PointList& rectangles_of(const graph::Node& node, std::string_view parameter)
{
    static const graph::PointList none;
    const graph::Value* value = node.parameter(parameter);
    const auto* list = value ? std::get_if<graph::PointList>(value) : nullptr;
    return list ? *list : none;
}

int side_of(const graph::Node& node)
{
    const graph::Value* value = node.parameter(graph::drawing_unit);
    const int* cells = value ? std::get_if<int>(value) : nullptr;
    return cells ? *cells : 1;
}

// Where the cells lie on the screen.
struct Sheet {
    static constexpr float far_cells = 4096;
    ImVec2 low;
    float cell_px;
    int side;

    ImVec2 corner(float x, float y) const  // y upwards from the lower left
    {
        return {low.x + x * cell_px, low.y + (static_cast<float>(side) - y) * cell_px};
    }
    // A mouse that is nowhere is immensely far away: no whole number says where.
    glm::ivec2 cell(ImVec2 at) const
    {
        glm::vec2 from_corner = glm::floor(glm::vec2(at.x - low.x, at.y - low.y) / cell_px);
        glm::ivec2 cells(glm::clamp(from_corner, -far_cells, far_cells));
        return {cells.x, side - 1 - cells.y};
    }
};

// A line of cells, mirrored when asked; the same for one cell.
void draw_line(Drawing& drawing, glm::ivec2 from, glm::ivec2 to, bool on, bool mirrored)
{
    int steps = std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), 1});
    for (int i = 0; i <= steps; ++i) {
        glm::vec2 at = glm::mix(glm::vec2(from), glm::vec2(to), static_cast<float>(i) / static_cast<float>(steps));
        glm::ivec2 cell(glm::floor(at + 0.5f));
        drawing.fill(cell.x, cell.y, on);
        if (mirrored) drawing.fill(drawing.side() - 1 - cell.x, cell.y, on);
    }
}

void draw_rectangle(Drawing& drawing, glm::ivec2 from, glm::ivec2 to, bool on, bool mirrored)
{
    for (int y = std::min(from.y, to.y); y <= std::max(from.y, to.y); ++y)
        draw_line(drawing, {from.x, y}, {to.x, y}, on, mirrored);
}

// The drawing after this frame of the stroke.
Drawing stroked(const DrawingView& view, const Drawing& now, glm::ivec2 cell)
{
    const DrawingView::Stroke& stroke = view.stroke;
    bool freehand = view.tool == "paint" || view.tool == "erase";
    Drawing drawing = freehand ? now : stroke.before;
    if (view.tool == "rectangle") draw_rectangle(drawing, stroke.start, cell, stroke.on, view.mirrored);
    else draw_line(drawing, freehand ? stroke.last : stroke.start, cell, stroke.on, view.mirrored);
    return drawing;
}

void paint_sheet(const FrameContext& frame, const Sheet& sheet, const graph::PointList& rectangles)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    auto side = static_cast<float>(sheet.side);
    ImVec2 high = sheet.corner(side, 0);
    draw.AddRectFilled(sheet.low, high, colour::window);
    ImGui::PushClipRect(sheet.low, high, true);
    for (const glm::vec4& r : rectangles) {
        ImVec2 a = sheet.corner(r.x - std::abs(r.z), r.y + std::abs(r.w));
        ImVec2 b = sheet.corner(r.x + std::abs(r.z), r.y - std::abs(r.w));
        draw.AddRectFilled(a, b, colour::rgb(0xaeb8c6));
    }
    ImU32 tint = colour::with_alpha(colour::line, 0.45f);
    for (int i = 1; i < sheet.side && sheet.cell_px >= frame.theme.px(5); ++i) {
        auto at = static_cast<float>(i);
        draw.AddLine(sheet.corner(at, side), sheet.corner(at, 0), tint);
        draw.AddLine(sheet.corner(0, at), sheet.corner(side, at), tint);
    }
    for (const glm::vec4& r : rectangles)
        draw.AddRect(sheet.corner(r.x - std::abs(r.z), r.y + std::abs(r.w)),
                     sheet.corner(r.x + std::abs(r.z), r.y - std::abs(r.w)), colour::rgb(0x4d5866), 0, 0,
                     frame.theme.px(1.5f));
    if (frame.view.drawing.mirrored)
        draw.AddLine(sheet.corner(0.5f * side, side), sheet.corner(0.5f * side, 0), colour::axes[0]);
    ImGui::PopClipRect();
    draw.AddRect(sheet.low, high, colour::line);
}

const std::vector<glm::ivec2>* missed_cells(const FrameContext& frame, graph::NodeId node)
{
    if (!frame.readings.missed_cells) return nullptr;
    auto found = frame.readings.missed_cells->find(node);
    return found == frame.readings.missed_cells->end() ? nullptr : &found->second;
}

// Cells that the solid does not show; one may just have been erased.
void paint_missed(const FrameContext& frame, const Sheet& sheet, graph::NodeId node)
{
    const std::vector<glm::ivec2>* missed = missed_cells(frame, node);
    if (!missed) return;
    for (glm::ivec2 cell : *missed) {
        auto x = static_cast<float>(cell.x), y = static_cast<float>(cell.y);
        if (cell.x >= sheet.side || cell.y >= sheet.side) continue;
        ImVec2 low = sheet.corner(x + 0.15f, y + 0.85f), high = sheet.corner(x + 0.85f, y + 0.15f);
        ImGui::GetWindowDrawList()->AddRectFilled(low, high, colour::warning, frame.theme.px(1));
    }
}

void paint_cursor(const FrameContext& frame, const Sheet& sheet, glm::ivec2 cell)
{
    if (cell.x < 0 || cell.y < 0 || cell.x >= sheet.side || cell.y >= sheet.side) return;
    auto outline = [&](int x) {
        auto left = static_cast<float>(x), bottom = static_cast<float>(cell.y);
        ImGui::GetWindowDrawList()->AddRect(sheet.corner(left, bottom + 1), sheet.corner(left + 1, bottom),
                                            colour::accent, 0, 0, frame.theme.px(1.5f));
    };
    outline(cell.x);
    if (frame.view.drawing.mirrored) outline(sheet.side - 1 - cell.x);
}

std::string step_words(std::string_view verb, const graph::Node& node, const graph::Library& library)
{
    return std::string(verb) + " " + graph::title_inside(node, library);
}

void write(FrameContext& frame, graph::NodeId id, std::string_view parameter, std::string_view verb,
           const Drawing& drawing)
{
    graph::Document& document = frame.draft.document;
    const graph::Node& node = *document.root.find(id);
    std::string step = step_words(verb, node, frame.draft.library);
    bool resized = side_of(node) != drawing.side();
    bool done = frame.draft.done(
        step, graph::set_parameter(document, frame.draft.library, id, std::string(parameter), drawing.rectangles()));
    if (done && resized)
        frame.draft.done(step,
                         graph::set_parameter(document, frame.draft.library, id, graph::drawing_unit, drawing.side()));
}

void sheet_field(FrameContext& frame, const std::string& path, graph::NodeId id, const std::string& parameter)
{
    const graph::Node& node = *frame.draft.document.root.find(id);
    DrawingView& view = frame.view.drawing;
    float width = ImGui::GetContentRegionAvail().x, room = std::min(width, frame.theme.px(300));
    int side = side_of(node);
    float cell_px = std::max(std::floor(room / static_cast<float>(side)), 1.0f);
    float length = cell_px * static_cast<float>(side);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(std::floor(0.5f * (width - length)), 0.0f));
    Sheet sheet{ImGui::GetCursorScreenPos(), cell_px, side};
    ImGui::InvisibleButton("canvas", {length, length},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    frame.rects.mark(path + "/canvas");
    bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    glm::ivec2 cell = sheet.cell(ImGui::GetIO().MousePos);
    paint_sheet(frame, sheet, rectangles_of(node, parameter));
    paint_missed(frame, sheet, id);
    if (hovered || active) {
        paint_cursor(frame, sheet, cell);
        frame.view.hint = "Drag to paint, drag with the right button to erase";
    }
    if (!active) return;
    Drawing now(rectangles_of(node, parameter), side);
    if (ImGui::IsItemActivated())
        view.stroke = {now, cell, cell, view.tool != "erase" && !ImGui::IsMouseDown(ImGuiMouseButton_Right)};
    Drawing drawing = stroked(view, now, cell);
    view.stroke.last = cell;
    if (drawing != now) write(frame, id, parameter, view.stroke.on ? "Paint" : "Erase", drawing);
}

void tools(FrameContext& frame, const std::string& path)
{
    DrawingView& view = frame.view.drawing;
    segments(frame, path + "/tool",
             {{"paint", "Paint"}, {"erase", "Erase"}, {"line", "Line"}, {"rectangle", "Rectangle"}}, view.tool);
    to_row_end(frame);
    const char* tip = view.mirrored ? "Mirrored: both halves are painted at once" : "Paint both halves at once";
    if (icon_button(frame, "mirror", icon::mirror, tip, colour::quiet_text, view.mirrored))
        view.mirrored = !view.mirrored;
    frame.rects.mark(path + "/mirror");
}

Drawing inverted(Drawing drawing)
{
    for (int y = 0; y < drawing.side(); ++y)
        for (int x = 0; x < drawing.side(); ++x) drawing.fill(x, y, !drawing.filled(x, y));
    return drawing;
}

// Every cell becomes four; or four become one, filled when at least two were.
Drawing finer(const Drawing& drawing)
{
    Drawing fine(2 * drawing.side());
    for (int y = 0; y < fine.side(); ++y)
        for (int x = 0; x < fine.side(); ++x) fine.fill(x, y, drawing.filled(x / 2, y / 2));
    return fine;
}

Drawing coarser(const Drawing& drawing)
{
    Drawing coarse(drawing.side() / 2);
    for (int y = 0; y < coarse.side(); ++y)
        for (int x = 0; x < coarse.side(); ++x) {
            int filled = 0;
            for (int part = 0; part < 4; ++part) filled += drawing.filled(2 * x + part % 2, 2 * y + part / 2);
            coarse.fill(x, y, filled >= 2);
        }
    return coarse;
}

void buttons(FrameContext& frame, const std::string& path, graph::NodeId id, const std::string& parameter)
{
    const graph::Node& node = *frame.draft.document.root.find(id);
    int side = side_of(node);
    auto now = [&] { return Drawing(rectangles_of(*frame.draft.document.root.find(id), parameter), side); };
    float gap = frame.theme.gap(), width = std::floor((ImGui::GetContentRegionAvail().x - 3 * gap) / 4);
    auto button = [&](const char* name, const char* label, bool enabled, const char* tip) {
        if (std::string_view(name) != "clear") ImGui::SameLine(0, gap);
        ImGui::BeginDisabled(!enabled);
        bool pressed = text_button(frame, name, label, width);
        ImGui::EndDisabled();
        frame.rects.mark(path + "/" + name);
        tooltip(frame, tip);
        return pressed;
    };
    if (button("clear", "Clear", true, "Empty all cells")) write(frame, id, parameter, "Clear", Drawing(side));
    if (button("invert", "Invert", true, "Fill what is empty and empty what is filled"))
        write(frame, id, parameter, "Invert", inverted(now()));
    if (button("finer", "Finer", 2 * side <= graph::drawing_side_limit, "Twice as many cells each way, the same shape"))
        write(frame, id, parameter, "Refine", finer(now()));
    if (button("coarser", "Coarser", side >= 2 && side % 2 == 0, "Half as many cells each way"))
        write(frame, id, parameter, "Coarsen", coarser(now()));
}

}  // namespace

std::string drawing_words(const graph::Node& node, const graph::PointList& rectangles)
{
    int cells = Drawing(rectangles, side_of(node)).count();
    auto counted = [](std::size_t count, const char* word) {
        return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
    };
    return counted(rectangles.size(), "rectangle") + ", " + counted(static_cast<std::size_t>(cells), "cell");
}

void drawing_field(FrameContext& frame, std::string_view path, graph::NodeId node, const graph::Parameter& parameter)
{
    std::string at(path), name = parameter.name;
    ImGui::PushID("drawing");
    tools(frame, at);
    sheet_field(frame, at, node, name);
    buttons(frame, at, node, name);
    if (const std::vector<glm::ivec2>* missed = missed_cells(frame, node)) {
        notice(frame, icon::info, colour::warning,
               "The marked cells, " + std::to_string(missed->size()) + " of them, do not show in the solid.");
        frame.rects.mark(at + "/missed");
    }
    ImGui::PopID();
}

}  // namespace fieldwright::ui
