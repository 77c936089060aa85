// Contours: closed outlines in one list of points, of which a marked one begins the next.
#pragma once

#include "graph/value.h"

#include <array>
#include <string_view>

namespace fieldwright::graph {

// The unit of a list parameter whose points are contours: x, y, and in z a 1 where a contour begins.
inline constexpr const char* contour_unit = "em";
inline constexpr std::size_t contour_side_limit = 512;  // what an outlined shape's loop runs over

// The parameters that say how contours are written. Where a group exposes one of them, each node of it has contours of
// its own.
inline constexpr std::array<std::string_view, 5> writing_parameters = {"text", "font", "letter_spacing", "line_spacing",
                                                                       "alignment"};

// The sides from point to point and back to the first of each contour: x and y of the start, x and y of the end. A
// contour is there with all its sides or not at all; what goes beyond `contour_side_limit` is left out.
PointList sides_of(const PointList& contours);

}  // namespace fieldwright::graph
