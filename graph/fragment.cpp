// Copies of nodes: taken from a document, and put into one.
#include "graph/fragment.h"

#include "graph/draft.h"
#include "graph/json.h"
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
        bool output = is_output(*library.type(node.type));
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

Pasted plant(Document& document, const Library& library, const Fragment& fragment, glm::vec2 shift_px,
             Incoming incoming)
{
    Draft draft(document, library);
    std::vector<NodeId> added = Planting(draft, fragment).plant(shift_px, incoming);
    if (Refusal refusal = draft.finish({}).refusal) return {{}, refusal};
    return {std::move(added), std::nullopt};
}

}  // namespace

std::string copy_nodes(const Document& document, const Library&, const std::set<NodeId>& ids)
{
    std::vector<Node> nodes;
    for (const Node& node : document.root.nodes)
        if (ids.contains(node.id) && node.unknown_source.empty()) nodes.push_back(node);
    return nodes.empty() ? std::string() : write_fragment(nodes);
}

Pasted paste_nodes(Document& document, const Library& library, std::string_view text, glm::vec2 position,
                   Incoming incoming)
{
    if (text.find(fragment_format) == std::string_view::npos)
        return {{}, "the clipboard holds no nodes; copy some first"};
    try {
        Fragment fragment = read_fragment(text, library);
        if (fragment.nodes.empty()) return {{}, "the clipboard holds no nodes of a type known here"};
        drop_second_outputs(fragment, document, library);
        if (fragment.nodes.empty()) return {{}, "a scene has one output, and this one has it already"};
        return plant(document, library, fragment, position - corner(fragment.nodes), incoming);
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
