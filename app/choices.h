// What the renderer offers, in the words of the window.
#pragma once

#include "ui/readings.h"

namespace fieldwright::app {

// Views, stereo modes, colour maps and styles of slices.
void fill_choices(ui::Readings& readings);

}  // namespace fieldwright::app
