// A parameter's value as it stands in JSON.
#pragma once

#include "graph/library.h"
#include "graph/scene_json.h"

namespace fieldwright::graph {

// Of the parameter's kind and within its range, else a failure. Not of a material, which has no value.
Value read_value(const SceneJson& json, const JsonValue& value, const Parameter& parameter);

}  // namespace fieldwright::graph
