// Every view of a frame in one picture, each with its name, and a legend where its colours mean numbers: the display's
// own view does not count.
#pragma once

#include "renderer/picture.h"

namespace fieldwright::app {

renderer::Picture contact_sheet(const renderer::Frame& frame, int step_limit, const renderer::Display& display);

}  // namespace fieldwright::app
