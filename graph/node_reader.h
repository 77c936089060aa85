// One node of a scene's JSON, without its wires.
#pragma once

#include "graph/document.h"
#include "graph/library.h"
#include "graph/scene_json.h"

namespace fieldwright::graph {

// The node without its id and wires; of a type that `library` lacks it is a placeholder: what can be shown of it, and
// its text. Returns its `inputs`, null when it has none or is a placeholder.
const JsonValue* read_node(const SceneJson& json, const JsonValue& value, const Library& library, Node& node);

}  // namespace fieldwright::graph
