// The plane of the distance slice that the viewport shows, and where its points lie in the picture.
#pragma once

#include "ui/frame_context.h"

#include <optional>

namespace fieldwright::ui {

struct SliceFrame {
    glm::vec3 centre{0}, right{1, 0, 0}, up{0, 1, 0};  // world space, m; right and up are unit vectors
    float height = 4;                                  // m, of the picture

    // px from the top left of a picture of that size.
    glm::vec3 point(glm::vec2 at_px, glm::vec2 size_px) const;
    glm::vec2 place(glm::vec3 point, glm::vec2 size_px) const;  // of the nearest point of the plane
    float above(glm::vec3 point) const;                         // m; positive towards who looks at it
};

// "ray" without an inspected ray is the first plane.
SliceFrame slice_frame(const ViewState& view, const Readings& readings);

// Over the slice: the inspected ray, and the spheres of its steps as far as they cut the plane.
void draw_slice_overlay(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane);
// What is under the mouse, in words.
std::string slice_hint(const FrameContext& frame, glm::vec2 at_px, glm::vec2 size_px);

}  // namespace fieldwright::ui
