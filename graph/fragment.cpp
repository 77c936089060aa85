// Copies of nodes: taken from a document, and put into one.
#include "graph/fragment.h"

#include "graph/draft.h"
#include "graph/group_edits.h"
#include "graph/group_types.h"
#include "graph/json.h"
#include "graph/own_type_edits.h"
#include "graph/own_types.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <map>

namespace fieldwright::graph {
namespace {

Fragment taken_from(const Document& document, const std::set<NodeId>& ids)
{
    Fragment fragment;
    for (const Node& node : document.root.nodes)
        if (ids.contains(node.id) && node.unknown_source.empty()) fragment.nodes.push_back(node);
    for (Node& node : fragment.nodes) {
        auto from_outside = [&](const auto& input) { return !ids.contains(input.second); };
        for (const auto& input : node.inputs)
            if (from_outside(input)) fragment.incoming.push_back({input.second, node.id, input.first});
        std::erase_if(node.inputs, from_outside);
    }
    return fragment;
}

// A scene has one output: the first of either.
void drop_second_outputs(Fragment& fragment, const Document& document, const Library& library)
{
    bool taken = shown_output(document, library) != nullptr;
    std::erase_if(fragment.nodes, [&](const Node& node) {
        const NodeType* type = library.type(node.type);
        bool output = type && is_output(*type);
        return output && std::exchange(taken, true);
    });
}

glm::vec2 corner(const std::vector<Node>& nodes)
{
    glm::vec2 least = nodes.front().position;
    for (const Node& node : nodes) least = glm::min(least, node.position);
    return least;
}

// Puts copies of a fragment's nodes into a draft.
class Planting {
public:
    Planting(Draft& draft, const Fragment& fragment) : draft_(draft), fragment_(fragment) {}

    std::vector<NodeId> plant(glm::vec2 shift_px, Incoming incoming)
    {
        std::vector<NodeId> added;
        for (const Node& node : fragment_.nodes) added.push_back(add(node, shift_px));
        for (const Node& node : fragment_.nodes)
            for (const auto& [socket, source] : node.inputs)
                if (copies_.contains(source)) draft_.wire(copies_[source], copies_[node.id], socket);
        draft_.make_wires();
        if (incoming == Incoming::keep && !draft_.refused()) wire_incoming();
        return added;
    }

private:
    NodeId add(const Node& node, glm::vec2 shift_px)
    {
        NodeId id = draft_.add(node.type, node.position + shift_px);
        if (!id) return id;
        for (const auto& [name, value] : node.parameters) draft_.set(id, name, value);
        draft_.refuse(rename_node(draft_.document(), id, node.name));
        draft_.refuse(set_muted(draft_.document(), id, node.muted));
        return copies_[node.id] = id;
    }

    // Those that fit; the ids may be of another document than this.
    void wire_incoming()
    {
        Document known = draft_.document();
        WireRules rules(known.root, draft_.library());
        rules.add_all();
        for (const Wire& wire : fragment_.incoming) {
            auto target = copies_.find(wire.target);
            if (target == copies_.end() || wire.source >= first_copy()) continue;
            if (!rules.add(wire.source, target->second, wire.socket))
                draft_.wire(wire.source, target->second, wire.socket);
        }
    }

    NodeId first_copy() const { return copies_.begin()->second; }

    Draft& draft_;
    const Fragment& fragment_;
    std::map<NodeId, NodeId> copies_;  // by the copied id; both ascend
};

bool uses_type(const Graph& graph, std::string_view type)
{
    return std::any_of(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) { return node.type == type; });
}

// The fragment's own types go into the document, those that it has already apart.
Refusal bring_types(Fragment& fragment, Document& document, const Library& library)
{
    for (const OwnType& own : fragment.own_types) {
        if (const OwnType* known = find_own_type(document, own.name); known && *known == own) continue;
        OwnType added = own;
        if (find_own_type(document, own.name) || !own_name_error(library, own.name).empty())
            added = renamed(own, fresh_own_name(document, library, own.name));
        if (Refusal refusal = add_own_type(document, library, added)) return refusal;
        auto retype = [&](std::vector<Node>& nodes) {
            for (Node& node : nodes)
                if (node.type == own.name) node.type = added.name;
        };
        retype(fragment.nodes);
        for (Group& group : fragment.groups) retype(group.graph.nodes);
    }
    return std::nullopt;
}

Pasted plant(Document& document, const Library& library, const Fragment& fragment, glm::vec2 shift_px,
             Incoming incoming)
{
    Draft draft(document, library);
    std::vector<NodeId> added = Planting(draft, fragment).plant(shift_px, incoming);
    if (Refusal refusal = draft.finish({}).refusal) return {{}, refusal};
    return {std::move(added), std::nullopt};
}

// The groups first, as the nodes may be of them.
Pasted plant_with_groups(Document& document, const Library& library, Fragment fragment, glm::vec2 position,
                         Incoming incoming)
{
    glm::vec2 shift_px = position - corner(fragment.nodes);
    Document with_groups = document;
    Imported imported = import_groups(with_groups, fragment.groups);
    if (imported.refusal) return {{}, imported.refusal};
    for (Node& node : fragment.nodes)
        if (node.type.starts_with(group_prefix))
            node.type = group_type_name(imported.names.at(node.type.substr(group_prefix.size())));
    Pasted pasted = plant(with_groups, *library_of(with_groups, library), fragment, shift_px, incoming);
    if (!pasted.refusal) document = std::move(with_groups);
    return pasted;
}

}  // namespace

std::string copy_nodes(const Document& document, const Library&, const std::set<NodeId>& ids)
{
    Graph copied;
    for (const Node& node : document.root.nodes)
        if (ids.contains(node.id) && node.unknown_source.empty()) copied.nodes.push_back(node);
    if (copied.nodes.empty()) return {};
    std::vector<Group> groups = with_inner_groups(document, groups_used_by(copied));
    std::vector<OwnType> own_types = document.own_types;
    std::erase_if(own_types, [&](const OwnType& own) {
        bool used = uses_type(copied, own.name);
        for (const Group& group : groups) used = used || uses_type(group.graph, own.name);
        return !used;
    });
    return write_fragment(copied.nodes, own_types, groups);
}

Pasted paste_nodes(Document& document, const Library& library, std::string_view text, glm::vec2 position,
                   Incoming incoming)
{
    if (text.find(fragment_format) == std::string_view::npos)
        return {{}, "the clipboard holds no nodes; copy some first"};
    try {
        Fragment fragment = read_fragment(text, library);
        if (fragment.nodes.empty()) return {{}, "the clipboard holds no nodes of a type known here"};
        Document with_types = document;
        if (Refusal refusal = bring_types(fragment, with_types, library)) return {{}, refusal};
        std::shared_ptr<const Library> known = with_own_types(library, with_types.own_types);
        drop_second_outputs(fragment, document, *known);
        if (fragment.nodes.empty()) return {{}, "a scene has one output, and this one has it already"};
        Pasted pasted = plant_with_groups(with_types, *known, std::move(fragment), position, incoming);
        if (!pasted.refusal) document = std::move(with_types);
        return pasted;
    } catch (const Failure& failure) {
        return {{}, std::string("the nodes cannot be pasted: ") + failure.what()};
    }
}

Pasted duplicate_nodes(Document& document, const Library& library, const std::set<NodeId>& ids, glm::vec2 offset_px,
                       Incoming incoming)
{
    for (NodeId id : ids)
        if (!document.root.find(id)) return {{}, "there is no node " + std::to_string(id.number)};
    Fragment fragment = taken_from(document, ids);
    drop_second_outputs(fragment, document, library);
    if (fragment.nodes.empty()) return {{}, "none of the selected nodes can be duplicated"};
    return plant(document, library, fragment, offset_px, incoming);
}

}  // namespace fieldwright::graph
