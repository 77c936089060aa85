// Painting the minimap.
#include "ui/canvas_minimap.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr float share_of_pane = 0.2f, smallest_pane = 300, margin = 8, inset = 6;  // design px
constexpr float covering_alpha = 0.5f;

bool has_room(glm::vec2 pane_px, const Theme& theme)
{
    return std::min(pane_px.x, pane_px.y) >= theme.px(smallest_pane);
}

}  // namespace

glm::vec2 Minimap::room_px(glm::vec2 pane_px, const Theme& theme)
{
    if (!has_room(pane_px, theme)) return {0, 0};
    return share_of_pane * pane_px + 2 * theme.px(inset) + theme.px(margin);
}

void Minimap::place(const CanvasLayout& layout, const CanvasSpace& space, const Theme& theme)
{
    std::optional<Box> bounds = layout.bounds();
    shown_ = bounds && has_room(space.size_px, theme);
    if (!shown_) return;
    Box seen = space.visible();
    shown_ = !seen.contains(bounds->low) || !seen.contains(bounds->high);  // else there is nothing to look for
    if (!shown_) return;
    Box whole = bounds->grown(40).with(seen);
    glm::vec2 border{2 * theme.px(inset)}, room = share_of_pane * space.size_px;
    scale_ = std::min(room.x / whole.size().x, room.y / whole.size().y);
    glm::vec2 corner = space.pane_px().high - theme.px(margin);
    box_px_ = {glm::floor(corner - scale_ * whole.size() - border), glm::floor(corner)};
    origin_px_ = box_px_.centre() - scale_ * whole.centre();
}

void Minimap::paint(ImDrawList& list, const CanvasLayout& layout, const CanvasSpace& space, const Selection& selection,
                    glm::vec2 mouse_px) const
{
    bool covers = std::any_of(layout.nodes().begin(), layout.nodes().end(),
                              [&](const CanvasNode& node) { return space.screen(node.box).touches(box_px_); });
    float alpha = covers && !box_px_.contains(mouse_px) ? covering_alpha : 1;
    auto ink = [&](ImU32 tint, float strength = 1) { return colour::with_alpha(tint, strength * alpha); };
    auto rect = [&](const Box& box) {
        glm::vec2 low = glm::max(screen(box.low), box_px_.low), high = glm::min(screen(box.high), box_px_.high);
        return std::pair(ImVec2(low.x, low.y), ImVec2(std::max(high.x, low.x + 2), std::max(high.y, low.y + 2)));
    };
    ImVec2 low{box_px_.low.x, box_px_.low.y}, high{box_px_.high.x, box_px_.high.y};
    list.AddRectFilled(low, high, ink(colour::panel, 0.92f), 4);
    for (const CanvasNode& node : layout.nodes()) {
        auto [node_low, node_high] = rect(node.box);
        bool selected = selection.contains(node.node->id);
        list.AddRectFilled(node_low, node_high,
                           ink(selected ? colour::accent : category_colour(node.type ? node.type->category : "")));
    }
    auto [seen_low, seen_high] = rect(space.visible());
    list.AddRectFilled(seen_low, seen_high, ink(colour::text, 0.05f));
    list.AddRect(seen_low, seen_high, ink(colour::text, 0.5f));
    list.AddRect(low, high, ink(colour::line), 4);
}

}  // namespace fieldwright::ui
