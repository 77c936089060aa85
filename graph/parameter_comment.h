// A parameter, read from the comment that declares it.
#pragma once

#include "graph/library.h"

namespace fieldwright::graph {

// From an argument and its comment: `default [min, max] [soft min, soft max] unit  help`, `formula "default"  help`,
// `image  help`, or of a material the help alone. An argument without a type is a text: `"default"  help`. Throws
// DialectError, which names `file`.
Parameter parameter_of(const Argument& argument, const std::string& file);

}  // namespace fieldwright::graph
