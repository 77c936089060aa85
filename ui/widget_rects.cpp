// Rectangles of the widgets of one frame.
#include "ui/widget_rects.h"

#include <imgui.h>

namespace fieldwright::ui {

void WidgetRects::mark(std::string_view name)
{
    if (!listening) return;
    ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    mark(name, {{low.x, low.y}, {high.x, high.y}});
}

void WidgetRects::mark(std::string_view name, WidgetRect rect)
{
    if (listening) rects_.insert_or_assign(std::string(name), rect);
}

std::optional<WidgetRect> WidgetRects::find(std::string_view name) const
{
    auto found = rects_.find(name);
    if (found == rects_.end()) return std::nullopt;
    return found->second;
}

}  // namespace fieldwright::ui
