// A picture of everything around as the light that comes from there.
#pragma once

#include "assets/picture_file.h"
#include "graph/image_request.h"

namespace fieldwright::assets {

// Pixels proportional to light, equirectangular, at most `request.detail` columns. The list is that of
// graph/image_request.h.
graph::BakedImage panorama(const Pixels& pixels);

}  // namespace fieldwright::assets
