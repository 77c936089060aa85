// A part of a picture as signed distances on a grid.
#pragma once

#include "assets/picture_file.h"
#include "graph/image_request.h"

namespace fieldwright::assets {

constexpr int pixels_wanted(int detail) { return 4 * detail; }

// Pixels on the shown scale; around the picture all is outside. The line is where brightness
// between the middles of pixels crosses the level: an edge a pixel wide, as drawing programs make, is found to 0.12 of a
// pixel, with 1.5 pixels a sample or more to 0.06. The samples are the distances to that line, in single precision, at
// most 0.9 spacings off on creases far from it; between them bilinear interpolation adds spacing^2 / (8 radius).
// Without an edge in it, the result is a sentence that begins with `subject`.
// More pixels than samples are well spent, up to `pixels_wanted` along the longer side: they smooth the edge.
graph::BakedImage baked(const Pixels& pixels, const graph::ImageRequest& request, const std::string& subject);

}  // namespace fieldwright::assets
