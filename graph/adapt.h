// Brings a document up to date with another node library: what a document promises holds again.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

namespace fieldwright::graph {

// Nodes whose type is gone become placeholders that save as they were; placeholders whose type is there are read again.
// New parameters get their defaults, removed ones go, values out of range move to its end. Wires that no longer fit go.
// Groups lose what they exposed of nodes that are gone; one whose output is gone gives what its last unread node gives.
// A document that fits already is returned unchanged. At rest.
Document adapted(Document document, const Library& library);

}  // namespace fieldwright::graph
