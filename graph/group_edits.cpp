// Edits of groups as a whole: their names, copies, and bringing them into documents. grouping.cpp makes and dissolves
// them, interface_edits.cpp changes what they show outside.
#include "graph/group_edits.h"

#include "graph/adapt.h"
#include "graph/group_changes.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/limits.h"
#include "graph/words.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

bool equal_but_for_ids(const Group& a, const Group& b)
{
    std::int64_t next_a = 1, next_b = 1;
    return renumbered(a, next_a) == renumbered(b, next_b);
}

}  // namespace

Placed make_group_unique(Document& document, NodeId id)
{
    Node* node = document.root.find(id);
    if (!node) return {{}, no_node(id)};
    const Group* group = group_of(document, *node);
    if (!group) return {{}, std::string(no_group_node)};
    if (uses_of(document, group->name) < 2) return {{}, "no other node is of the group " + titled(group->name)};
    if (node_count(document) + group->graph.nodes.size() > node_limit)
        return {{}, "a scene has at most " + std::to_string(node_limit) + " nodes"};
    Group copy = renumbered(*group, document.next_id);
    copy.name = free_group_name(document, group->name);
    node->type = group_type_name(copy.name);
    insert_group(document.groups, std::move(copy));
    return {id, std::nullopt};
}

Refusal rename_group(Document& document, std::string_view group_name, std::string_view name)
{
    AtRest rest(document);
    Group* group = find_group(document, group_name);
    if (!group) return no_group(group_name);
    if (name == group_name) return std::nullopt;
    if (Refusal refusal = group_name_error(name)) return refusal;
    if (find_group(document, name)) return "there is a group " + titled(name) + " already; choose another name";
    std::map<std::string, std::string> names = {{group->name, std::string(name)}};
    Group renamed = std::move(*group);
    document.groups.erase(place_by_name(document.groups, group_name));
    rest.renamed(names.begin()->first, name);
    renamed.name = name;
    insert_group(document.groups, std::move(renamed));
    for_each_graph(document, [&](Graph& graph) { rename_types(graph, names); });
    return std::nullopt;
}

Refusal delete_group(Document& document, std::string_view name)
{
    if (!find_group(document, name)) return no_group(name);
    if (document.entered == name) return "this group is open; leave it first";
    if (std::size_t uses = uses_of(document, name))
        return (uses == 1 ? "1 node is" : std::to_string(uses) + " nodes are") + " of the group " + titled(name) +
               "; delete " + (uses == 1 ? "it" : "them") + " first";
    document.groups.erase(place_by_name(document.groups, name));
    return std::nullopt;
}

Imported import_groups(Document& document, const std::vector<Group>& groups)
{
    Imported imported;
    AtRest rest(document);
    Document source, changed = document;
    source.groups = groups;
    for (const Group* group : inner_first(source)) {
        Group wanted = *group;
        rename_types(wanted.graph, imported.names);
        const Group* known = find_group(changed, group->name);
        imported.names[group->name] = group->name;
        if (known && equal_but_for_ids(*known, wanted)) continue;
        if (node_count(changed) + wanted.graph.nodes.size() > node_limit || changed.groups.size() >= group_limit) {
            imported.refusal = "a scene has at most " + std::to_string(node_limit) + " nodes and 1000 groups";
            return imported;
        }
        wanted = renumbered(wanted, changed.next_id);
        wanted.name = imported.names[group->name] = free_group_name(changed, group->name);
        insert_group(changed.groups, std::move(wanted));
    }
    document = std::move(changed);
    return imported;
}

std::vector<Group> with_inner_groups(const Document& document, const std::set<std::string>& names)
{
    std::set<std::string> needed;
    for (std::vector<std::string> stack(names.begin(), names.end()); !stack.empty();) {
        const Group* group = find_group(document, stack.back());
        stack.pop_back();
        if (!group || !needed.insert(group->name).second) continue;
        for (const std::string& inner : groups_used_by(group->graph)) stack.push_back(inner);
    }
    std::vector<Group> groups;
    for (const std::string& name : needed) groups.push_back(*find_group(document, name));
    return groups;
}

std::shared_ptr<const Library> settle_groups(Document& document, const Library& library)
{
    AtRest rest(document);
    std::shared_ptr<const Library> fresh = with_groups(library, document);
    auto changed = [&](const Group& group) {
        const NodeType* before = library.type(group_type_name(group.name));
        const NodeType* now = fresh->type(group_type_name(group.name));
        bool lost = !group.output || !group.graph.find(group.output);
        for (const Exposed& exposed : group.exposed) lost = lost || !group.graph.find(exposed.node);
        return lost || (before && now && !same_interface(*before, *now));
    };
    if (std::none_of(document.groups.begin(), document.groups.end(), changed)) return fresh;
    document = adapted(std::move(document), library);
    return with_groups(library, document);
}

}  // namespace fieldwright::graph
