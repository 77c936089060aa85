// What closed contours cover together, as contours that nowhere cross.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace fieldwright::assets {

using Contour = std::vector<glm::dvec2>;  // closed: the last point is joined to the first

// A point is covered where the contours wind around it (nonzero rule). The result bounds exactly that: every side has
// the covered part on its left and none on its right, so that the even-odd rule fills it, too. Corners are rounded to
// multiples of 2^-17, and what is thinner vanishes.
std::vector<Contour> contour_union(const std::vector<Contour>& contours);

}  // namespace fieldwright::assets
