// Edits of groups: what changes hands between a graph and the inside of a group, and what a group shows outside.
#include "graph/group_edits.h"

#include "graph/adapt.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/limits.h"
#include "graph/neighbours.h"
#include "graph/wire_rules.h"
#include "graph/words.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

constexpr const char* no_group_node = "this node is not a group";

std::string shown(const Node& node, const Library& library)
{
    return named(Wording::titles, node, library.type(node.type));
}

std::string no_node(NodeId id) { return "there is no node " + std::to_string(id.number); }
std::string no_group(std::string_view name) { return "there is no group " + titled(name); }

auto place_by_name(std::vector<Group>& groups, std::string_view name)
{
    return std::lower_bound(groups.begin(), groups.end(), name,
                            [](const Group& group, std::string_view wanted) { return group.name < wanted; });
}

void insert(std::vector<Group>& groups, Group group)
{
    auto place = place_by_name(groups, group.name);
    groups.insert(place, std::move(group));
}

void wire(Node& node, std::string_view socket, NodeId source)
{
    std::erase_if(node.inputs, [&](const auto& input) { return input.first == socket; });
    if (source) node.inputs.emplace_back(socket, source);
    std::sort(node.inputs.begin(), node.inputs.end());
}

void let_read(Graph& graph, NodeId before, NodeId heir)
{
    for (Node& node : graph.nodes) {
        for (auto& [socket, source] : node.inputs)
            if (source == before) source = heir;
        std::erase_if(node.inputs, [](const auto& input) { return !input.second; });
    }
}

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

// What an input or parameter is called when it is exposed.
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

// Moves selected nodes of the graph that is worked on into a group.
class Grouping {
public:
    Grouping(const Document& document, const Library& library, const std::set<NodeId>& nodes)
        : document_(document), library_(library), nodes_(nodes)
    {
    }

    Refusal check()
    {
        if (nodes_.empty()) return "nothing is selected; select the nodes that make the group";
        if (document_.groups.size() >= group_limit) return "a scene has at most 1000 groups";
        for (NodeId id : nodes_) {
            const Node* node = document_.root.find(id);
            if (!node) return no_node(id);
            const NodeType* type = library_.type(node->type);
            if (!type) return shown(*node, library_) + " is of a type this version does not know and stays where it is";
            if (is_output(*type)) return "the output stays in the scene; leave it out of the group";
        }
        if (Refusal refusal = between_error()) return refusal;
        return find_output();
    }

    // The group node.
    NodeId move(Document& document, std::string_view name)
    {
        Group group;
        group.name = free_group_name(document, group_name_error(name) ? "Group" : name);
        group.output = output_;
        Node outer;
        outer.type = group_type_name(group.name);
        outer.position = document.root.find(output_)->position;
        for (NodeId id : nodes_) group.graph.nodes.push_back(*document.root.find(id));
        for (Node& node : group.graph.nodes) expose_wires(group, node, outer);
        std::erase_if(document.root.nodes, [&](const Node& node) { return nodes_.contains(node.id); });
        outer.id = {document.next_id++};
        take_along_exposed(document, outer.id, group);
        std::sort(outer.inputs.begin(), outer.inputs.end());
        for (const Parameter& parameter : group_type(group, library_).parameters)
            if (parameter.kind != ParameterKind::material)
                outer.parameters.emplace_back(parameter.name, parameter.initial);
        let_read(document.root, output_, outer.id);
        document.root.nodes.push_back(outer);
        if (Group* around = find_group(document, document.entered); around && around->output == output_)
            around->output = outer.id;
        insert(document.groups, std::move(group));
        return outer.id;
    }

private:
    // The one whose result leaves the selection.
    Refusal find_output()
    {
        Readers readers(document_.root);
        std::vector<NodeId> read_outside, unread;
        const Group* around = find_group(document_, document_.entered);
        for (NodeId id : nodes_) {
            std::span<const Wire> wires = readers.of(id);
            bool outside = std::any_of(wires.begin(), wires.end(),
                                       [&](const Wire& wire) { return !nodes_.contains(wire.target); });
            if (outside || (around && around->output == id)) read_outside.push_back(id);
            if (wires.empty()) unread.push_back(id);
        }
        const std::vector<NodeId>& ends = read_outside.empty() ? unread : read_outside;
        if (ends.size() > 1)
            return "a group gives one result, but " + shown(*document_.root.find(ends[0]), library_) + " and " +
                   shown(*document_.root.find(ends[1]), library_) + " both give one; combine them or leave one out";
        output_ = ends.front();
        return std::nullopt;
    }

    // Nothing outside may lie between two of them.
    Refusal between_error() const
    {
        std::set<NodeId> seen;
        std::vector<NodeId> stack;
        for (NodeId id : nodes_)
            for (const auto& [socket, source] : document_.root.find(id)->inputs)
                if (!nodes_.contains(source)) stack.push_back(source);
        while (!stack.empty()) {
            NodeId id = stack.back();
            stack.pop_back();
            if (!seen.insert(id).second) continue;
            for (const auto& [socket, source] : document_.root.find(id)->inputs) {
                if (nodes_.contains(source))
                    return shown(*document_.root.find(id), library_) +
                           " lies between the selected nodes; select it too";
                stack.push_back(source);
            }
        }
        return std::nullopt;
    }

    void expose_wires(Group& group, Node& node, Node& outer) const
    {
        for (const auto& [socket, source] : node.inputs) {
            if (nodes_.contains(source)) continue;
            std::string name = exposed_name(group, node, socket);
            group.exposed.push_back({name, {}, node.id, socket});
            outer.inputs.emplace_back(name, source);
        }
        std::erase_if(node.inputs, [&](const auto& input) { return !nodes_.contains(input.second); });
    }

    // What the group around exposed of them, it exposes of the group node now.
    void take_along_exposed(Document& document, NodeId outer, Group& group) const
    {
        Group* around = find_group(document, document.entered);
        if (!around) return;
        for (Exposed& exposed : around->exposed) {
            if (!nodes_.contains(exposed.node)) continue;
            auto same = std::find_if(group.exposed.begin(), group.exposed.end(), [&](const Exposed& inner) {
                return inner.node == exposed.node && inner.socket == exposed.socket;
            });
            std::string name = same != group.exposed.end() ? same->name : free_exposed_name(group, exposed.name);
            if (same == group.exposed.end())
                group.exposed.push_back({name, exposed.help, exposed.node, exposed.socket});
            exposed.node = outer;
            exposed.socket = name;
        }
    }

    const Document& document_;
    const Library& library_;
    const std::set<NodeId>& nodes_;
    NodeId output_;
};

// A group's nodes under ids of a document, with the values and wires that a group node gives them.
struct Unpacked {
    std::vector<Node> nodes;
    NodeId output;
    std::map<NodeId, NodeId> ids;
};

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

void give(Unpacked& inner, const Group& group, const Node& outer)
{
    for (const Exposed& exposed : group.exposed) {
        auto id = inner.ids.find(exposed.node);
        if (id == inner.ids.end()) continue;
        auto node =
            std::find_if(inner.nodes.begin(), inner.nodes.end(), [&](const Node& one) { return one.id == id->second; });
        const Value* value = outer.parameter(exposed.name);
        for (auto& [name, current] : node->parameters)
            if (value && name == exposed.socket) current = *value;
        if (NodeId source = outer.input(exposed.name)) wire(*node, exposed.socket, source);
    }
}

// The group under ids of its own; nodes of unknown type, whose text names ids, are left out.
Group renumbered(const Group& group, std::int64_t& next_id)
{
    Unpacked inner = unpacked(group, next_id);
    Group copy{group.name, group.exposed, inner.output, {std::move(inner.nodes)}};
    std::erase_if(copy.exposed, [&](const Exposed& exposed) { return !inner.ids.contains(exposed.node); });
    for (Exposed& exposed : copy.exposed) exposed.node = inner.ids[exposed.node];
    return copy;
}

bool equal_but_for_ids(const Group& a, const Group& b)
{
    std::int64_t next_a = 1, next_b = 1;
    return renumbered(a, next_a) == renumbered(b, next_b);
}

void rename_types(Graph& graph, const std::map<std::string, std::string>& names)
{
    for (Node& node : graph.nodes) {
        if (!node.type.starts_with(group_prefix) || !node.unknown_source.empty()) continue;
        auto given = names.find(node.type.substr(group_prefix.size()));
        if (given != names.end()) node.type = group_type_name(given->second);
    }
}

}  // namespace

Placed group_nodes(Document& document, const Library& library, const std::set<NodeId>& nodes, std::string_view name)
{
    Grouping grouping(document, library, nodes);
    if (Refusal refusal = grouping.check()) return {{}, refusal};
    Document grouped = document;
    NodeId node = grouping.move(grouped, name);
    document = std::move(grouped);
    return {node, std::nullopt};
}

Pasted ungroup(Document& document, NodeId id)
{
    const Node* found = document.root.find(id);
    if (!found) return {{}, no_node(id)};
    const Group* group = group_of(document, *found);
    if (!group) return {{}, std::string(no_group_node)};
    if (found->muted) return {{}, std::string("the group is muted; unmute it first")};
    if (node_count(document) + group->graph.nodes.size() > node_limit)
        return {{}, "a scene has at most " + std::to_string(node_limit) + " nodes"};
    Node outer = *found;
    Document flat = document;
    Unpacked inner = unpacked(*group, flat.next_id);
    give(inner, *group, outer);
    const Node* output = group->graph.find(group->output);
    glm::vec2 shift = output ? outer.position - output->position : glm::vec2(0);
    std::vector<NodeId> added;
    for (Node& node : inner.nodes) {
        node.position += shift;
        added.push_back(node.id);
        flat.root.nodes.push_back(std::move(node));
    }
    let_read(flat.root, id, inner.output);
    std::erase_if(flat.root.nodes, [&](const Node& node) { return node.id == id; });
    if (Group* around = find_group(flat, flat.entered)) {
        if (around->output == id) around->output = inner.output;
        for (Exposed& exposed : around->exposed) {
            if (exposed.node != id) continue;
            for (const Exposed& within : group->exposed)
                if (within.name == exposed.socket && inner.ids.contains(within.node)) {
                    exposed.node = inner.ids[within.node];
                    exposed.socket = within.socket;
                    break;
                }
        }
    }
    if (!uses_of(flat, group->name)) flat.groups.erase(place_by_name(flat.groups, group->name));
    document = std::move(flat);
    return {std::move(added), std::nullopt};
}

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
    insert(document.groups, std::move(copy));
    return {id, std::nullopt};
}

Refusal expose(Document& document, const Library& library, std::string_view name, NodeId id, std::string_view socket)
{
    return change_group(document, &library, name, [&](Group& group) -> Refusal {
        Exposed exposed{{}, {}, id, std::string(socket)};
        const Node* node = group.graph.find(id);
        if (node && !library.type(node->type))
            return shown(*node, library) + " is of a type this version does not know";
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
    insert(document.groups, std::move(renamed));
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
        insert(changed.groups, std::move(wanted));
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
