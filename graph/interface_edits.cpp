// Edits of what a group shows outside.
#include "graph/adapt.h"
#include "graph/group_changes.h"
#include "graph/group_edits.h"
#include "graph/group_rules.h"
#include "graph/json.h"
#include "graph/limits.h"
#include "graph/words.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

// Whatever `change` does to a group, the nodes of it are fitted to afterwards.
template <typename Change>
Refusal change_group(Document& document, const Library* library, std::string_view name, Change change)
{
    AtRest rest(document);
    Document changed = document;
    Group* group = find_group(changed, name);
    if (!group) return no_group(name);
    if (Refusal refusal = change(*group)) return refusal;
    document = library ? adapted(std::move(changed), *library) : std::move(changed);
    return std::nullopt;
}

auto find_exposed(Group& group, std::string_view name)
{
    return std::find_if(group.exposed.begin(), group.exposed.end(),
                        [&](const Exposed& exposed) { return exposed.name == name; });
}

std::string not_exposed(const Group& group, std::string_view name)
{
    return "group " + titled(group.name) + " exposes nothing called " + titled(name);
}

}  // namespace

Refusal expose(Document& document, const Library& library, std::string_view name, NodeId id, std::string_view socket)
{
    return change_group(document, &library, name, [&](Group& group) -> Refusal {
        Exposed exposed{{}, {}, id, std::string(socket)};
        const Node* node = group.graph.find(id);
        if (node && !library.type(node->type))
            return title_of_node(*node, library) + " is of a type this version does not know";
        if (Refusal refusal = exposed_error(exposed, group.graph, library)) return refusal;
        if (node->input(socket)) return titled(socket) + " is wired inside the group; remove that wire first";
        if (group.exposed.size() >= exposed_limit) return "a group exposes at most 256 parameters";
        for (const Exposed& other : group.exposed)
            if (other.node == id && other.socket == socket) return "it is exposed already, as " + titled(other.name);
        exposed.name = exposed_name(group, *node, socket);
        group.exposed.push_back(std::move(exposed));
        return std::nullopt;
    });
}

Refusal hide(Document& document, const Library& library, std::string_view name, std::string_view exposed)
{
    return change_group(document, &library, name, [&](Group& group) -> Refusal {
        auto found = find_exposed(group, exposed);
        if (found == group.exposed.end()) return not_exposed(group, exposed);
        group.exposed.erase(found);
        return std::nullopt;
    });
}

Refusal rename_exposed(Document& document, std::string_view group_name, std::string_view exposed, std::string_view name)
{
    AtRest rest(document);
    Group* group = find_group(document, group_name);
    if (!group) return no_group(group_name);
    auto found = find_exposed(*group, exposed);
    if (found == group->exposed.end()) return not_exposed(*group, exposed);
    if (name == exposed) return std::nullopt;
    if (Refusal refusal = exposed_name_error(name)) return refusal;
    if (find_exposed(*group, name) != group->exposed.end())
        return "group " + titled(group->name) + " exposes something called " + titled(name) + " already";
    std::string type = group_type_name(group_name), before(exposed);
    found->name = name;
    for_each_graph(document, [&](Graph& graph) {
        std::set<NodeId> of_group;
        for (Node& node : graph.nodes) {
            if (node.type != type || !node.unknown_source.empty()) continue;
            of_group.insert(node.id);
            for (auto& [key, value] : node.parameters)
                if (key == before) key = name;
            for (auto& [socket, source] : node.inputs)
                if (socket == before) socket = name;
            std::sort(node.inputs.begin(), node.inputs.end());
        }
        for (Group& outer : document.groups)
            for (Exposed& further : outer.exposed)
                if (of_group.contains(further.node) && further.socket == before) further.socket = name;
    });
    return std::nullopt;
}

Refusal describe_exposed(Document& document, std::string_view name, std::string_view exposed, std::string_view help)
{
    if (help.size() > name_limit || !is_utf8(help)) return "a parameter's help is UTF-8 text of at most 256 bytes";
    return change_group(document, nullptr, name, [&](Group& group) -> Refusal {
        auto found = find_exposed(group, exposed);
        if (found == group.exposed.end()) return not_exposed(group, exposed);
        found->help = help;
        return std::nullopt;
    });
}

Refusal move_exposed(Document& document, const Library& library, std::string_view name, std::string_view exposed,
                     int by)
{
    return change_group(document, &library, name, [&](Group& group) -> Refusal {
        auto found = find_exposed(group, exposed);
        if (found == group.exposed.end()) return not_exposed(group, exposed);
        std::ptrdiff_t to = (found - group.exposed.begin()) + by;
        if (to < 0) return titled(exposed) + " is the first already";
        if (to >= std::ssize(group.exposed)) return titled(exposed) + " is the last already";
        Exposed moved = std::move(*found);
        group.exposed.erase(found);
        group.exposed.insert(group.exposed.begin() + to, std::move(moved));
        return std::nullopt;
    });
}

Refusal set_group_output(Document& document, const Library& library, std::string_view name, NodeId node)
{
    return change_group(document, &library, name, [&](Group& group) -> Refusal {
        if (!group.graph.find(node)) return no_node(node);
        if (Refusal refusal = group_output_error(node, group.graph, library)) return refusal;
        group.output = node;
        return std::nullopt;
    });
}

}  // namespace fieldwright::graph
