// The pixels of a distance slice in one area of its frame.
#pragma once

#include "renderer/frame.h"

namespace fieldwright::renderer {

// Colours, and distances in the place of depths. The request has a slice.
void draw_slice_area(Frame& frame, const FrameRequest& request, const Area& area, const DistancesAt& distances_at);

// The point of a slice at a place of its picture, pixels from the top left.
glm::vec3 slice_point(const Slice& slice, glm::vec2 at_px, glm::vec2 size_px);

}  // namespace fieldwright::renderer
