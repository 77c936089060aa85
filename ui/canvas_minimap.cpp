// Painting the minimap.
#include "ui/canvas_minimap.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr float share_of_pane = 0.2f, smallest_pane = 240, margin = 8, inset = 6;  // design px

}  // namespace

void Minimap::place(const CanvasLayout& layout, const CanvasSpace& space, const Theme& theme)
{
    std::optional<Box> bounds = layout.bounds();
    shown_ = bounds && std::min(space.size_px.x, space.size_px.y) >= theme.px(smallest_pane);
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

void Minimap::paint(ImDrawList& list, const CanvasLayout& layout, const CanvasSpace& space,
                    const Selection& selection) const
{
    auto rect = [&](const Box& box) {
        glm::vec2 low = glm::max(screen(box.low), box_px_.low), high = glm::min(screen(box.high), box_px_.high);
        return std::pair(ImVec2(low.x, low.y), ImVec2(std::max(high.x, low.x + 2), std::max(high.y, low.y + 2)));
    };
    ImVec2 low{box_px_.low.x, box_px_.low.y}, high{box_px_.high.x, box_px_.high.y};
    list.AddRectFilled(low, high, colour::with_alpha(colour::panel, 0.92f), 4);
    for (const CanvasNode& node : layout.nodes()) {
        auto [node_low, node_high] = rect(node.box);
        bool selected = selection.contains(node.node->id);
        list.AddRectFilled(node_low, node_high,
                           selected ? colour::accent : category_colour(node.type ? node.type->category : ""));
    }
    auto [seen_low, seen_high] = rect(space.visible());
    list.AddRectFilled(seen_low, seen_high, colour::with_alpha(colour::text, 0.05f));
    list.AddRect(seen_low, seen_high, colour::with_alpha(colour::text, 0.5f));
    list.AddRect(low, high, colour::line, 4);
}

}  // namespace fieldwright::ui
