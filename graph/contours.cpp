// From contours to their sides.
#include "graph/contours.h"

namespace fieldwright::graph {

PointList sides_of(const PointList& contours)
{
    PointList sides;
    for (std::size_t first = 0, last; first < contours.size(); first = last) {
        last = first + 1;
        while (last < contours.size() && contours[last].z < 0.5f) ++last;
        if (sides.size() + last - first > contour_side_limit) continue;
        for (std::size_t i = first; i < last; ++i) {
            const glm::vec4 &start = contours[i], &end = contours[i + 1 < last ? i + 1 : first];
            sides.emplace_back(start.x, start.y, end.x, end.y);
        }
    }
    return sides;
}

}  // namespace fieldwright::graph
