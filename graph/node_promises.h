// What the parts of a node type owe each other.
#pragma once

#include "graph/library.h"

namespace fieldwright::graph {

// Throws DialectError when a declared type breaks one of them.
void check_promises(const NodeType& type);

}  // namespace fieldwright::graph
