// The node types that a document's groups are: derived from what they contain.
#pragma once

#include "graph/groups.h"
#include "graph/library.h"

namespace fieldwright::graph {

// What the group's nodes look like from outside. `library` knows the types of everything inside; exposed things that are
// not there are left out.
NodeType group_type(const Group& group, const Library& library);
// The library with the groups of a document at rest and no others.
std::shared_ptr<const Library> with_groups(const Library& library, const Document& document);
// The same of a document that may be entered.
std::shared_ptr<const Library> library_of(Document& document, const Library& library);
// Whether nodes of one type fit where nodes of the other do: names, kinds and ranges are equal, defaults may differ.
bool same_interface(const NodeType& a, const NodeType& b);

}  // namespace fieldwright::graph
