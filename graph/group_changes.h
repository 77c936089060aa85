// What the edits of groups share: sentences, looking up and inserting groups, and groups under other ids.
#pragma once

#include "graph/groups.h"
#include "graph/library.h"

#include <map>

namespace fieldwright::graph {

inline constexpr const char* no_group_node = "this node is not a group";
std::string title_of_node(const Node& node, const Library& library);
std::string no_node(NodeId id);
std::string no_group(std::string_view name);

std::vector<Group>::iterator place_by_name(std::vector<Group>& groups, std::string_view name);
void insert_group(std::vector<Group>& groups, Group group);
// Nodes of groups follow the names that these were given.
void rename_types(Graph& graph, const std::map<std::string, std::string>& names);
// What an input or parameter is called when it is exposed.
std::string exposed_name(const Group& group, const Node& node, std::string_view socket);

// A group's nodes under ids of a document, but for those of unknown type, whose text names ids.
struct Unpacked {
    std::vector<Node> nodes;
    NodeId output;
    std::map<NodeId, NodeId> ids;  // by those in the group
};
Unpacked unpacked(const Group& group, std::int64_t& next_id);
// The group under ids of its own.
Group renumbered(const Group& group, std::int64_t& next_id);

}  // namespace fieldwright::graph
