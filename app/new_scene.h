// The scene that a new document begins with: a solid on the ground under sun and sky.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

namespace fieldwright::app {

// Nodes that the library lacks are left out.
graph::Document new_scene(const graph::Library& library);

}  // namespace fieldwright::app
