// Making groups of nodes, and taking them apart.
#include "graph/group_changes.h"
#include "graph/group_edits.h"
#include "graph/group_rules.h"
#include "graph/group_types.h"
#include "graph/limits.h"
#include "graph/neighbours.h"
#include "graph/words.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

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
            if (!type)
                return title_of_node(*node, library_) +
                       " is of a type this version does not know and stays where it is";
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
        insert_group(document.groups, std::move(group));
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
            return "a group gives one result, but " + title_of_node(*document_.root.find(ends[0]), library_) + " and " +
                   title_of_node(*document_.root.find(ends[1]), library_) +
                   " both give one; combine them or leave one out";
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
                    return title_of_node(*document_.root.find(id), library_) +
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

void give(Unpacked& inner, const Group& group, const Node& outer)
{
    for (const auto& [before, id] : inner.ids) {
        auto node = std::find_if(inner.nodes.begin(), inner.nodes.end(), [&](const Node& one) { return one.id == id; });
        for (auto& [name, current] : node->parameters)
            if (const Value* value = outer.parameter(ready_made_name(before, name))) current = *value;
    }
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

}  // namespace fieldwright::graph
