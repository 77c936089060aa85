// Lights of a whole scene in one edit.
#pragma once

#include "graph/compose.h"

namespace fieldwright::graph {

// A sun with soft shadows, the sky that goes with it, and occlusion where it was off. An unmuted sun of the scene is
// kept, and the sky follows it. The new node is the sky; makes the output when there is none.
Placed add_outdoor_light(Document& document, const Library& library, glm::vec2 position);

}  // namespace fieldwright::graph
