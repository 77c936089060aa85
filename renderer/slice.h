// Distance slice: the field on a plane, one pixel a point.
#pragma once

#include "graph/slice_plane.h"
#include "renderer/colour_map.h"

#include <functional>
#include <span>

namespace fieldwright::renderer {

// In the order of slice_styles().
enum class SliceStyle { sign, grey, contour, gradient };

struct SliceStyleKind {
    const char *name, *title, *help;
};
std::span<const SliceStyleKind> slice_styles();
const std::vector<std::string>& slice_style_names();
std::optional<SliceStyle> slice_style_from_name(std::string_view name);

// A rectangle of a plane in world space; right and up are unit vectors at a right angle.
struct Slice {
    glm::vec3 centre{0}, right{1, 0, 0}, up{0, 1, 0};  // m
    float height = 4;                                  // m, of what the picture shows
    SliceStyle style = SliceStyle::sign;
    float gamma = 2.2f;    // of grey
    float spacing = 0.2f;  // m between lines of equal distance
    ColourMap colour_map = ColourMap::viridis;
    bool operator==(const Slice&) const = default;
};

// The plane at `offset` metres along the third axis; the point of the plane nearest to the origin is its centre.
Slice slice_of(const graph::SlicePlane& plane, float offset);

// What is known of the field at a pixel. change: of the distance from pixel to pixel; slope: length of the gradient.
struct SliceSample {
    float distance, change, slope;
};
// Linear Rec.709.
glm::vec3 slice_colour(const Slice& slice, const SliceSample& sample);

using DistancesAt = std::function<std::vector<float>(std::span<const glm::vec3>)>;

}  // namespace fieldwright::renderer
