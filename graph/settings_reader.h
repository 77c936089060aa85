// The members of a scene that are its settings.
#pragma once

#include "graph/document.h"
#include "graph/scene_json.h"

namespace fieldwright::graph {

// Whether the member of the scene is a setting, and then reads it into `document`.
bool read_setting(const SceneJson& json, const JsonValue& member, Document& document);

}  // namespace fieldwright::graph
