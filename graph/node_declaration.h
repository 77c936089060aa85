// Reads a node type out of its parsed file: header lines, parameter comments and function names.
#pragma once

#include "graph/library.h"

namespace fieldwright::graph {

// Throws DialectError (file, line, rule) when the file does not declare a node.
NodeType declare_node(SourceFile source);

}  // namespace fieldwright::graph
