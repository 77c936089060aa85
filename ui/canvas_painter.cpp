// Painting the grid, nodes, pins and wires.
#include "ui/canvas_painter.h"

#include "graph/leader.h"
#include "ui/icons.h"
#include "ui/node_words.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {

using graph::SocketKind;

namespace {

constexpr float title_size = 16, label_size = 14;  // canvas px
constexpr float node_rounding = 5, pin_size = 5;
constexpr float readable_px = 13;  // words do not get smaller while their row has room for them
constexpr const char* ellipsis = "\xe2\x80\xa6";

ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }
glm::vec2 whole(glm::vec2 v) { return {std::round(v.x), std::round(v.y)}; }

ImU32 mixed(ImU32 a, ImU32 b, float amount)
{
    ImVec4 from = ImGui::ColorConvertU32ToFloat4(a), to = ImGui::ColorConvertU32ToFloat4(b);
    return ImGui::ColorConvertFloat4ToU32(ImLerp(from, to, amount));
}

ImU32 header_colour(const CanvasNode& node)
{
    ImU32 full = category_colour(node.type ? node.type->category : "");
    return node.node->muted ? mixed(full, colour::node_body, 0.65f) : full;
}

ImU32 text_colour(const CanvasNode& node) { return node.node->muted ? colour::quiet_text : colour::text; }

float encoded(float linear)  // sRGB
{
    float c = std::clamp(linear, 0.0f, 1.0f);
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

ImU32 swatch_colour(glm::vec3 linear)
{
    return ImGui::ColorConvertFloat4ToU32({encoded(linear.r), encoded(linear.g), encoded(linear.b), 1});
}

// So many that no chord leaves the curve by more than a fifth of a pixel (the bound of a cubic's second derivative).
int segment_count(const WireCurve& curve_px)
{
    const auto& p = curve_px.points;
    float bend_px = std::max(glm::length(p[0] - 2.0f * p[1] + p[2]), glm::length(p[1] - 2.0f * p[2] + p[3]));
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(0.75f * bend_px / 0.2f))), 1, 64);
}

// A strip around a rounded box that fades from the inner to the outer one, which has its own rounding.
void fading_ring(ImDrawList& list, const Box& inner, float inner_rounding, const Box& outer, float outer_rounding,
                 ImU32 colour)
{
    constexpr int steps = 4, points = 4 * (steps + 1);  // to a corner
    list.PrimReserve(6 * points, 2 * points);
    ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    auto first = static_cast<ImDrawIdx>(list._VtxCurrentIdx);
    auto at = [](const Box& box, float rounding, int corner, float angle) {
        glm::vec2 middle{corner == 0 || corner == 3 ? box.high.x - rounding : box.low.x + rounding,
                         corner < 2 ? box.high.y - rounding : box.low.y + rounding};
        return im(middle + rounding * glm::vec2(std::cos(angle), std::sin(angle)));
    };
    for (int corner = 0; corner < 4; ++corner)
        for (int step = 0; step <= steps; ++step) {
            float angle = 0.5f * IM_PI * (static_cast<float>(corner) + static_cast<float>(step) / steps);
            list.PrimWriteVtx(at(inner, inner_rounding, corner, angle), white, colour);
            list.PrimWriteVtx(at(outer, outer_rounding, corner, angle), white, colour & ~IM_COL32_A_MASK);
        }
    for (int i = 0; i < points; ++i) {
        int here = 2 * i, next = 2 * ((i + 1) % points);
        for (int corner : {here, here + 1, next + 1, here, next + 1, next})
            list.PrimWriteIdx(static_cast<ImDrawIdx>(first + corner));
    }
}

// How many bytes of `text` fit `width`, at a border between characters.
std::size_t fitting_bytes(const ImFont& font, float size_px, std::string_view text, float width)
{
    const char* rest = text.data();
    if (width > 0) font.CalcTextSizeA(size_px, width, 0, text.data(), text.data() + text.size(), &rest);
    return static_cast<std::size_t>(rest - text.data());
}

}  // namespace

Detail detail_at(float zoom) { return zoom < 0.25f ? Detail::boxes : zoom < 0.5f ? Detail::titles : Detail::full; }

Box problem_badge(const Box& node)
{
    glm::vec2 middle{node.high.x - 22, node.low.y + 0.5f * node_header};
    return {middle - 9.0f, middle + 9.0f};
}

Box quality_badge(const Box& node, bool with_problem)
{
    glm::vec2 middle{node.high.x - (with_problem ? 40.0f : 20.0f), node.low.y + 0.5f * node_header};
    return {middle - 9.0f, middle + 9.0f};
}

CanvasPainter::CanvasPainter(ImDrawList& list, const Theme& theme, const CanvasSpace& space, float zoom)
    : list_(list), theme_(theme), space_(space), detail_(detail_at(zoom)), seen_(space.visible().grown(12))
{
}

// Two nets, each fading before its lines get crowded.
void CanvasPainter::grid()
{
    Box pane = space_.pane_px();
    for (float spacing : {24.0f, 120.0f, 600.0f}) {
        float step = px(spacing), strength = std::clamp((step - theme_.px(8)) / theme_.px(24), 0.0f, 1.0f);
        if (strength <= 0) continue;
        ImU32 lines = colour::with_alpha(colour::grid, strength);
        glm::vec2 first = space_.pan_px - glm::floor(space_.pan_px / step) * step;
        for (float x = first.x; x < space_.size_px.x; x += step)
            list_.AddRectFilled(im({std::round(pane.low.x + x), pane.low.y}),
                                im({std::round(pane.low.x + x) + 1, pane.high.y}), lines);
        for (float y = first.y; y < space_.size_px.y; y += step)
            list_.AddRectFilled(im({pane.low.x, std::round(pane.low.y + y)}),
                                im({pane.high.x, std::round(pane.low.y + y) + 1}), lines);
    }
}

void CanvasPainter::wire(const WireCurve& curve, SocketKind kind, WireLook look)
{
    if (!visible(curve.box())) return;
    ImU32 colour = socket_colour(kind);
    bool strong = look == WireLook::hovered || look == WireLook::selected;
    float alpha = look == WireLook::faint ? 0.3f : strong ? 1.0f : 0.75f;
    float width = std::max((strong ? 3.0f : 2.0f) * std::min(space_.scale, theme_.px(1.5f)), theme_.px(1));
    if (look == WireLook::hovered) colour = mixed(colour, colour::text, 0.4f);
    // Of whole pixels, a line is a strip of the font's texture: half the vertices, which software GL feels.
    stroke_in_sight(curve, colour::with_alpha(colour, alpha), std::round(width));
}

// Only the stretches of a wire that are seen: most wires of a large graph come from far away.
void CanvasPainter::stroke_in_sight(const WireCurve& curve, ImU32 colour, float width_px)
{
    WireCurve on_screen;
    for (std::size_t i = 0; i < 4; ++i) on_screen.points[i] = space_.screen(curve.points[i]);
    Box pane = space_.pane_px().grown(width_px);
    int segments = segment_count(on_screen);
    glm::vec2 from = on_screen.points[0];
    auto stroke = [&] {
        if (list_._Path.Size > 1) list_.PathStroke(colour, 0, width_px);
        list_.PathClear();
    };
    for (int i = 1; i <= segments; ++i) {
        glm::vec2 to = on_screen.at(static_cast<float>(i) / static_cast<float>(segments));
        if (box_between(from, to).touches(pane)) {
            if (list_._Path.Size == 0) list_.PathLineTo(im(from));
            list_.PathLineTo(im(to));
        } else {
            stroke();
        }
        from = to;
    }
    stroke();
}

void CanvasPainter::node(const CanvasNode& node, const NodeLook& look)
{
    if (!visible(node.box)) return;
    Box screen = space_.screen(node.box);
    Box box_px{whole(screen.low), whole(screen.high)};
    if (detail_ == Detail::boxes) plain_box(node, look, box_px);
    else if (detail_ == Detail::titles) title_box(node, look, box_px);
    else full_box(node, look, box_px);
}

void CanvasPainter::plain_box(const CanvasNode& node, const NodeLook& look, const Box& box_px)
{
    list_.AddRectFilled(im(box_px.low), im(box_px.high), header_colour(node));
    if (look.selected || look.hovered || look.problem) outline(box_px, look, 0);
}

void CanvasPainter::title_box(const CanvasNode& node, const NodeLook& look, const Box& box_px)
{
    float rounding = px(node_rounding), size = std::max(px(title_size), theme_.px(readable_px));
    float strip = std::max(size + theme_.px(1), std::round(px(node_header)));
    bool whole = box_px.size().y < strip + theme_.px(3);
    if (whole) strip = box_px.size().y;
    list_.AddRectFilled(im(box_px.low), im(box_px.high), colour::node_body, rounding);
    list_.AddRectFilled(im(box_px.low), {box_px.high.x, box_px.low.y + strip}, header_colour(node), rounding,
                        whole ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersTop);
    outline(box_px, look, rounding);
    float inset = theme_.px(5), width = box_px.size().x - 2 * inset;
    if (!look.renamed)
        text({box_px.low.x + inset, box_px.low.y + 0.5f * (strip - size)}, size, text_colour(node),
             node_title(*node.node, node.type), width, true);
    if (node.node->muted) bypass_line(node, box_px);
}

void CanvasPainter::full_box(const CanvasNode& node, const NodeLook& look, const Box& box_px)
{
    float rounding = px(node_rounding);
    shadow(box_px, rounding);
    list_.AddRectFilled(im(box_px.low), im(box_px.high), colour::node_body, rounding);
    header(node, look, box_px);
    for (std::size_t i = 0; i < node.input_count(); ++i) row(node, i);
    outline(box_px, look, rounding);
    if (node.node->muted) bypass_line(node, box_px);
}

void CanvasPainter::shadow(const Box& box_px, float rounding)
{
    glm::vec2 down{0, px(3)};
    Box under{box_px.low + down, box_px.high + down};
    fading_ring(list_, under.grown(-rounding), 0, under.grown(px(9)), rounding + px(9), IM_COL32(0, 0, 0, 110));
}

void CanvasPainter::outline(const Box& box_px, const NodeLook& look, float rounding)
{
    bool error = look.problem && look.problem->severity == graph::Problem::Severity::error;
    ImU32 line = look.selected  ? colour::accent
                 : error        ? colour::error
                 : look.hovered ? colour::quiet_text
                                : colour::line;
    float width = theme_.px(look.selected ? 2.0f : error ? 1.5f : 1.0f);
    list_.AddRect(im(box_px.low), im(box_px.high), line, rounding, 0, width);
}

void CanvasPainter::header(const CanvasNode& node, const NodeLook& look, const Box& box_px)
{
    bool alone = node.input_count() == 0;
    glm::vec2 corner{box_px.high.x, alone ? box_px.high.y : std::round(box_px.low.y + px(node_header))};
    list_.AddRectFilled(im(box_px.low), im(corner), header_colour(node), px(node_rounding),
                        alone ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersTop);
    float right = box_px.high.x - px(12);
    float size = std::max(px(title_size), std::min(theme_.px(readable_px), px(node_header - 2)));
    if (look.problem) {
        Box badge = space_.screen(problem_badge(node.box));
        bool error = look.problem->severity == graph::Problem::Severity::error;
        list_.AddCircleFilled(im(badge.centre()), px(8.5f), colour::node_body);
        float width = text_width(px(14), error ? icon::error : icon::warning);
        text({badge.centre().x - 0.5f * width, badge.centre().y - px(7)}, px(14),
             error ? colour::error : colour::warning, error ? icon::error : icon::warning, px(20));
        right = badge.low.x - px(2);
    }
    if (node.type && node.type->is_field() && node.type->category != "output") {
        Box badge = space_.screen(quality_badge(node.box, look.problem));
        const char* sign = quality_words(*node.type).sign;
        float width = text_width(size, sign);
        text({badge.centre().x - 0.5f * width, badge.centre().y - 0.5f * size}, size,
             colour::with_alpha(colour::text, 0.6f), sign, px(16));
        right = badge.low.x - px(2);
    }
    if (look.renamed) return;
    float left = box_px.low.x + px(10);
    text({left, box_px.low.y + px(0.5f * node_header) - 0.5f * size}, size, text_colour(node),
         node_title(*node.node, node.type), right - left, true);
}

float CanvasPainter::label_px() const
{
    return std::max(px(label_size), std::min(theme_.px(readable_px), px(node_row - 6)));
}

void CanvasPainter::row(const CanvasNode& node, std::size_t row)
{
    glm::vec2 pin_px = space_.screen(node.input_pin(row));
    std::string label = socket_label(node.type, node.input_name(row));
    float size = label_px(), left = pin_px.x + px(12), room = px(node_width - 24);
    text({left, pin_px.y - 0.5f * size}, size, colour::quiet_text, label, room);
    if (node.type && !node.node->input(node.input_name(row)))
        row_value(node, row, left + std::min(text_width(size, label), room) + px(8), pin_px.y);
}

// What an unwired parameter is, right-aligned.
void CanvasPainter::row_value(const CanvasNode& node, std::size_t row, float left_px, float middle_px)
{
    const graph::Parameter* parameter = node.type->parameter(node.input_name(row));
    const graph::Value* value = parameter ? node.node->parameter(parameter->name) : nullptr;
    if (!value) return;
    float right = space_.screen(node.box.high).x - px(10), size = label_px();
    if (parameter->kind == graph::ParameterKind::colour && std::holds_alternative<glm::vec3>(*value)) {
        list_.AddRectFilled(im({right - px(28), middle_px - px(7)}), im({right, middle_px + px(7)}),
                            swatch_colour(std::get<glm::vec3>(*value)), px(3));
        return;
    }
    bool led = node.leader && graph::is_led(*node.node, *parameter, *node.leader_type);
    std::string words = led ? "from " + node_title(*node.leader, node.leader_type) : value_text(*parameter, *value);
    float width = text_width(size, words), room = right - left_px;
    if (width > room && !std::holds_alternative<std::string>(*value)) return;  // half a number is another number
    width = std::min(width, room);
    text({right - width, middle_px - 0.5f * size}, size, text_colour(node), words, width + 1);
}

// A muted node is dimmed, and shows what it passes on: its first wired shape, or nothing.
void CanvasPainter::bypass_line(const CanvasNode& node, const Box& box_px)
{
    list_.AddRectFilled(im(box_px.low), im(box_px.high), colour::with_alpha(colour::canvas, 0.15f), px(node_rounding));
    float width = std::max(px(2), theme_.px(1));
    for (std::size_t row = 0; row < node.input_count(); ++row) {
        if (!node.node->input(node.input_name(row)) || !has_output(node.type)) continue;
        list_.AddLine(im(space_.screen(node.input_pin(row))), im(space_.screen(node.output_pin())),
                      socket_colour(node.input_kind(row)), width);
        return;
    }
    glm::vec2 inset{px(6), px(6)};
    list_.AddLine(im(box_px.low + inset), im(box_px.high - inset), colour::quiet_text, width);
}

void CanvasPainter::pin(glm::vec2 at, SocketKind kind, bool wired, PinLook look)
{
    if (detail_ == Detail::boxes || !visible({at, at})) return;
    ImVec2 middle = im(space_.screen(at));
    float radius = std::max(px(pin_size), theme_.px(2.5f)) * (look == PinLook::hovered ? 1.3f : 1.0f);
    ImU32 edge = socket_colour(kind), fill = wired ? edge : mixed(colour::node_body, edge, 0.25f);
    if (look == PinLook::dim) {
        edge = mixed(colour::node_body, edge, 0.3f);
        fill = mixed(colour::node_body, fill, 0.3f);
    }
    if (look == PinLook::glowing || look == PinLook::hovered)
        list_.AddCircleFilled(middle, radius * 1.9f, colour::with_alpha(edge, 0.25f));
    auto polygon = [&](int corners, float turned, float size, ImU32 colour) {
        for (int i = 0; i < corners; ++i) {
            float angle = turned + 2 * IM_PI * static_cast<float>(i) / static_cast<float>(corners);
            list_.PathLineTo({middle.x + size * std::cos(angle), middle.y + size * std::sin(angle)});
        }
        list_.PathFillConvex(colour);
    };
    auto shape = [&](float size, ImU32 colour) {
        switch (kind) {
            case SocketKind::field2d:
            case SocketKind::field3d:
            case SocketKind::field_any: polygon(4, 0, 1.25f * size, colour); return;
            case SocketKind::material: polygon(4, IM_PI / 4, 1.25f * size, colour); return;
            case SocketKind::camera: polygon(3, 0, 1.3f * size, colour); return;
            case SocketKind::sky: polygon(6, 0, 1.1f * size, colour); return;
            default: polygon(detail_ == Detail::full ? 12 : 8, 0, size, colour); return;
        }
    };
    float half_line = 0.5f * std::max(px(1.5f), theme_.px(1));
    shape(radius + half_line, edge);
    if (fill != edge) shape(radius - half_line, fill);
}

void CanvasPainter::caption(const Box& node, std::string_view words)
{
    if (detail_ != Detail::full) return;
    Box box = space_.screen(node);
    float size = px(12);
    text({box.low.x, box.high.y + px(4)}, size, colour::quiet_text, words, 2 * px(node_width));
}

void CanvasPainter::cost(const Box& node, std::string_view words)
{
    if (detail_ == Detail::boxes) return;
    Box box = space_.screen(node);
    float size = std::max(px(12), theme_.px(11)), width = text_width(size, words), inset = theme_.px(4);
    ImVec2 low(box.high.x - width - 2 * inset, box.low.y - size - 2 * theme_.px(2)), high(box.high.x, box.low.y);
    list_.AddRectFilled(low, high, colour::veil, theme_.px(3), ImDrawFlags_RoundCornersTop);
    text({low.x + inset, low.y + theme_.px(2)}, size, colour::quiet_text, words, width + 1);
}

void CanvasPainter::selection_box(const Box& box)
{
    Box box_px = space_.screen(box);
    list_.AddRectFilled(im(box_px.low), im(box_px.high), colour::with_alpha(colour::accent, 0.1f));
    list_.AddRect(im(box_px.low), im(box_px.high), colour::with_alpha(colour::accent, 0.8f), 0, 0, theme_.px(1));
}

// The way back to the start is fainter: the hand has not drawn it.
void CanvasPainter::lasso(const std::vector<glm::vec2>& points)
{
    list_.AddLine(im(space_.screen(points.back())), im(space_.screen(points.front())),
                  colour::with_alpha(colour::accent, 0.4f), theme_.px(1));
    for (glm::vec2 point : points) list_.PathLineTo(im(space_.screen(point)));
    list_.PathStroke(colour::with_alpha(colour::accent, 0.8f), 0, theme_.px(1.5f));
}

void CanvasPainter::cut_stroke(const std::vector<glm::vec2>& points)
{
    for (glm::vec2 point : points) list_.PathLineTo(im(space_.screen(point)));
    list_.PathStroke(colour::error, 0, theme_.px(2));
}

float CanvasPainter::text_width(float size_px, std::string_view text, bool heading) const
{
    const ImFont& font = *canvas_font(theme_, size_px, heading).font;
    return font.CalcTextSizeA(size_px, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

bool CanvasPainter::text(glm::vec2 at_px, float size_px, ImU32 colour, std::string_view text, float width_px,
                         bool heading)
{
    const ImFont* font = canvas_font(theme_, size_px, heading).font;
    glm::vec2 at = whole(at_px);
    const char *first = text.data(), *last = first + text.size();
    if (font->CalcTextSizeA(size_px, FLT_MAX, 0, first, last).x <= width_px) {
        list_.AddText(font, size_px, im(at), colour, first, last);
        return true;
    }
    float dots = font->CalcTextSizeA(size_px, FLT_MAX, 0, ellipsis).x;
    if (width_px < dots) return false;
    std::string cut(text.substr(0, fitting_bytes(*font, size_px, text, width_px - dots)));
    while (!cut.empty() && cut.back() == ' ') cut.pop_back();
    cut += ellipsis;
    list_.AddText(font, size_px, im(at), colour, cut.c_str());
    return false;
}

}  // namespace fieldwright::ui
