#include "graph/group_changes.h"

#include "graph/group_rules.h"
#include "graph/words.h"

#include <algorithm>

namespace fieldwright::graph {

std::string title_of_node(const Node& node, const Library& library)
{
    return named(Wording::titles, node, library.type(node.type));
}

std::string no_node(NodeId id) { return "there is no node " + std::to_string(id.number); }
std::string no_group(std::string_view name) { return "there is no group " + titled(name); }

std::vector<Group>::iterator place_by_name(std::vector<Group>& groups, std::string_view name)
{
    return std::lower_bound(groups.begin(), groups.end(), name,
                            [](const Group& group, std::string_view wanted) { return group.name < wanted; });
}

void insert_group(std::vector<Group>& groups, Group group)
{
    auto place = place_by_name(groups, group.name);
    groups.insert(place, std::move(group));
}

void rename_types(Graph& graph, const std::map<std::string, std::string>& names)
{
    for (Node& node : graph.nodes) {
        if (!node.type.starts_with(group_prefix) || !node.unknown_source.empty()) continue;
        auto given = names.find(node.type.substr(group_prefix.size()));
        if (given != names.end()) node.type = group_type_name(given->second);
    }
}

std::string exposed_name(const Group& group, const Node& node, std::string_view socket)
{
    std::string name(socket);
    if (socket == "d") name = "shape";
    if (socket == "a") name = "first_shape";
    if (socket == "b") name = "second_shape";
    if (free_exposed_name(group, name) == name) return name;
    std::string of_node = (node.name.empty() ? node.type : node.name) + " " + name;
    if (of_node.size() > group_name_limit || exposed_name_error(of_node)) of_node = name;
    return free_exposed_name(group, of_node);
}

Unpacked unpacked(const Group& group, std::int64_t& next_id)
{
    Unpacked result;
    for (const Node& node : group.graph.nodes)
        if (node.unknown_source.empty()) result.ids[node.id] = {next_id++};
    for (const Node& node : group.graph.nodes) {
        if (!result.ids.contains(node.id)) continue;
        Node& copy = result.nodes.emplace_back(node);
        copy.id = result.ids[node.id];
        std::erase_if(copy.inputs, [&](const auto& input) { return !result.ids.contains(input.second); });
        for (auto& [socket, source] : copy.inputs) source = result.ids[source];
    }
    auto output = result.ids.find(group.output);
    if (output != result.ids.end()) result.output = output->second;
    return result;
}

Group renumbered(const Group& group, std::int64_t& next_id)
{
    Unpacked inner = unpacked(group, next_id);
    Group copy{group.name, group.exposed, inner.output, {std::move(inner.nodes)}};
    std::erase_if(copy.exposed, [&](const Exposed& exposed) { return !inner.ids.contains(exposed.node); });
    for (Exposed& exposed : copy.exposed) exposed.node = inner.ids[exposed.node];
    return copy;
}

}  // namespace fieldwright::graph
