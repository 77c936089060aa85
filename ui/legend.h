// What the colours of a picture of numbers mean.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// A colour map with a title, and what stands at its ends.
struct Legend {
    const ColourMapChoice* map = nullptr;
    std::string title, low, middle, high;
    bool marks_exhausted = false;  // magenta: out of steps
};

// Of a view, by its name; nothing when it has no scale.
std::optional<Legend> legend_of(const FrameContext& frame, std::string_view view);
// The bar and its numbers, at the cursor of `list`; its height.
float draw_legend_bar(const FrameContext& frame, ImDrawList& list, ImVec2 low, float width_px, const Legend& legend);
// A number of a scale, without digits that say nothing: "0.1", "12.5", "2", "2,048".
std::string scale_text(double number);
// Of a share from 0 to 1.
ImU32 map_colour(const ColourMapChoice& map, float share);

}  // namespace fieldwright::ui
