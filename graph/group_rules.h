// What every document promises about its groups, and the names that they and what they expose may have.
#pragma once

#include "graph/edits.h"
#include "graph/groups.h"

namespace fieldwright::graph {

inline constexpr std::size_t group_limit = 1000;     // in a document
inline constexpr std::size_t exposed_limit = 256;    // of a group
inline constexpr std::size_t group_name_limit = 64;  // bytes, as of what is exposed

Refusal group_name_error(std::string_view name);
Refusal exposed_name_error(std::string_view name);
// Why a node's parameter or input cannot be exposed, or nothing. Of a node of unknown type nothing is checked.
Refusal exposed_error(const Exposed& exposed, const Graph& graph, const Library& library);
// Why the node cannot be the output of a group of this graph; nothing for NodeId{}.
Refusal group_output_error(NodeId output, const Graph& graph, const Library& library);

// First broken promise about groups, or nothing; nodes and wires are `validate`'s. `library` knows the groups.
Refusal groups_error(const Document& document, const Library& library);

// `wished`, or the first of "wished 2", "wished 3", ... that is not taken.
std::string free_group_name(const Document& document, std::string_view wished);
std::string free_exposed_name(const Group& group, std::string_view wished);

}  // namespace fieldwright::graph
