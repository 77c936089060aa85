// What a group of a scene's JSON shows outside: its output and what it exposes.
#pragma once

#include "graph/document.h"
#include "graph/library.h"
#include "graph/scene_json.h"

namespace fieldwright::graph {

// `group` has its graph already, whose nodes are of `library`.
void read_interface(const SceneJson& json, const JsonValue& value, const Library& library, Group& group);

}  // namespace fieldwright::graph
