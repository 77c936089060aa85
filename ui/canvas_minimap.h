// Minimap: the whole graph small in the lower right corner; pressing or dragging on it moves what is seen.
#pragma once

#include "ui/canvas_layout.h"
#include "ui/canvas_space.h"
#include "ui/theme.h"

namespace fieldwright::ui {

class Minimap {
public:
    // Of the pane that `space` fills. Hidden when the pane is small or there is nothing to show.
    void place(const CanvasLayout& layout, const CanvasSpace& space, const Theme& theme);
    // The most it takes of the lower right corner.
    static glm::vec2 room_px(glm::vec2 pane_px, const Theme& theme);
    bool shown() const { return shown_; }
    const Box& box_px() const { return box_px_; }
    // Fainter while nodes lie under it and the mouse is elsewhere.
    void paint(ImDrawList& list, const CanvasLayout& layout, const CanvasSpace& space, const Selection& selection,
               glm::vec2 mouse_px) const;
    glm::vec2 canvas(glm::vec2 screen_px) const { return (screen_px - origin_px_) / scale_; }

private:
    glm::vec2 screen(glm::vec2 canvas) const { return origin_px_ + scale_ * canvas; }

    Box box_px_;
    glm::vec2 origin_px_{0, 0};
    float scale_ = 1;
    bool shown_ = false;
};

}  // namespace fieldwright::ui
