// Edits of the node types that belong to a document. After one of them the document's library is another: its nodes
// hold what documents promise once they are adapted to it (graph/own_types.h, graph/adapt.h).
#pragma once

#include "graph/edits.h"

namespace fieldwright::graph {

const OwnType* find_own_type(const Document& document, std::string_view name);  // null when the document has none
std::size_t uses_of_own_type(const Document& document, std::string_view name);  // nodes

Refusal add_own_type(Document& document, const Library& library, OwnType type);
Refusal set_own_type_text(Document& document, std::string_view name, std::string text);
// In the text, too, and at every node of the type. Refused while the text is broken.
Refusal rename_own_type(Document& document, const Library& library, std::string_view name, std::string_view new_name);
Refusal remove_own_type(Document& document, std::string_view name);  // refused while it is used
// `node`, the only one or one of several of its type, gets a type of its own with the same text.
Refusal make_type_single(Document& document, const Library& library, NodeId node);

// `wish`, or with a number that makes it free.
std::string fresh_own_name(const Document& document, const Library& library, std::string_view wish);
// The type under another name: words of the text that begin with the old one follow.
OwnType renamed(const OwnType& type, std::string_view new_name);

}  // namespace fieldwright::graph
