// Search over node types, for the add menu.
#pragma once

#include "graph/library.h"

#include <span>

namespace fieldwright::graph {

// Those of `types` that match, best first: a whole text before its beginning, before the beginning of a word, before
// letters in order. Among equals the name counts before the title, the synonyms in their order and the category; then
// comes what is in `recent` (names, latest first), then the shorter title, then the given order. An empty query matches all and keeps the order.
std::vector<const NodeType*> search_types(std::span<const NodeType* const> types, std::string_view query,
                                          const std::vector<std::string>& recent = {});

}  // namespace fieldwright::graph
