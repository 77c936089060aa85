// Copies groups into the scene: first every graph is placed as often as it is used, then the wires are followed.
#include "graph/expansion.h"

#include "graph/group_types.h"
#include "graph/limits.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <memory>

namespace fieldwright::graph {
namespace {

struct Level;

struct PlacedNode {
    Node node;                      // with the values that the outside gives it
    NodeId copy;                    // of a node that is no group
    std::unique_ptr<Level> inside;  // of an unmuted group node
    bool is_group = false;
};

// A graph at one of its places: the scene, or the inside of a group node.
struct Level {
    const Level* outside = nullptr;    // null: the scene
    const PlacedNode* here = nullptr;  // the group node in `outside`
    const Group* group = nullptr;
    std::vector<NodeId> path;
    std::vector<PlacedNode> nodes;  // sorted by id

    const PlacedNode* find(NodeId id) const
    {
        auto found = std::lower_bound(nodes.begin(), nodes.end(), id,
                                      [](const PlacedNode& placed, NodeId wanted) { return placed.node.id < wanted; });
        return found != nodes.end() && found->node.id == id ? &*found : nullptr;
    }
};

// A node at a place, as the source of a wire.
struct Source {
    const Level* level;
    NodeId node;
};

const Exposed* exposed_at(const Level& level, NodeId node, std::string_view socket)
{
    if (!level.group) return nullptr;
    for (const Exposed& exposed : level.group->exposed)
        if (exposed.node == node && exposed.socket == socket) return &exposed;
    return nullptr;
}

// What is wired to a socket: outermost first.
Source wired_to(const Level& at_level, const PlacedNode& at_node, std::string_view socket)
{
    const Level* level = &at_level;
    const PlacedNode* node = &at_node;
    Source found{level, node->node.input(socket)};
    while (const Exposed* exposed = exposed_at(*level, node->node.id, socket)) {
        socket = exposed->name;
        node = level->here;
        level = level->outside;
        if (NodeId outer = node->node.input(socket)) found = {level, outer};
    }
    return found;
}

std::set<NodeId> made_of(const Graph& graph, NodeId output)
{
    std::set<NodeId> seen;
    for (std::vector<NodeId> stack = {output}; !stack.empty();) {
        const Node* node = graph.find(stack.back());
        stack.pop_back();
        if (!node || !seen.insert(node->id).second) continue;
        for (const auto& [socket, source] : node->inputs) stack.push_back(source);
    }
    return seen;
}

class Expander {
public:
    Expander(const Document& document, const Library& library)
        : document_(document), library_(with_groups(library, document)), next_id_(document.next_id)
    {
    }

    Expansion expand()
    {
        for (const Node& node : document_.root.nodes) scene_.nodes.push_back({node, node.id, nullptr});
        visited_ = scene_.nodes.size();
        enter(scene_);
        result_.document = rest();
        copy_nodes(scene_);
        std::sort(result_.document.root.nodes.begin(), result_.document.root.nodes.end(),
                  [](const Node& a, const Node& b) { return a.id < b.id; });
        result_.document.next_id = next_id_;
        return std::move(result_);
    }

private:
    // The settings of the scene without its graphs and types.
    Document rest() const
    {
        Document rest = document_;
        rest.root = {};
        rest.groups.clear();
        rest.own_types.clear();
        rest.extras.clear();
        return rest;
    }

    void enter(Level& level)
    {
        for (PlacedNode& placed : level.nodes) {
            const Group* group = group_of(document_, placed.node);
            placed.is_group = group != nullptr;
            if (!group || placed.node.muted || level.path.size() > group_depth_limit) continue;
            if (visited_ + group->graph.nodes.size() > node_limit) {
                refuse(level, placed.node);
                continue;
            }
            placed.inside = std::make_unique<Level>();
            placed.inside->outside = &level;
            placed.inside->here = &placed;
            placed.inside->group = group;
            placed.inside->path = level.path;
            placed.inside->path.push_back(placed.node.id);
            place(*placed.inside);
        }
    }

    void refuse(const Level& level, const Node& node)
    {
        std::string sentence = "the groups of this scene come to more than " + std::to_string(node_limit) +
                               " nodes; what does not fit is left out";
        if (result_.problems.empty())
            result_.problems.push_back({level.path.empty() ? node.id : level.path[0], sentence});
    }

    void place(Level& level)
    {
        std::set<NodeId> needed = made_of(level.group->graph, level.group->output);
        visited_ += needed.size() + 1;
        level.nodes.reserve(needed.size());
        for (NodeId id : needed) {
            PlacedNode& placed = level.nodes.emplace_back(PlacedNode{*level.group->graph.find(id), {}, nullptr});
            set_from_outside(level, placed.node);
            if (group_of(document_, placed.node)) continue;
            placed.copy = {next_id_++};
            result_.copies.push_back({placed.copy, level.path});
            result_.copies.back().path.push_back(id);
            result_.stand_ins.emplace(id, placed.copy);
        }
        enter(level);
    }

    void set_from_outside(const Level& level, Node& node) const
    {
        for (const Exposed& exposed : level.group->exposed) {
            if (exposed.node != node.id) continue;
            const Value* value = level.here->node.parameter(exposed.name);
            for (auto& [name, current] : node.parameters)
                if (value && name == exposed.socket) current = *value;
        }
        for (auto& [name, current] : node.parameters)
            if (std::holds_alternative<PointList>(current))
                if (const Value* value = level.here->node.parameter(ready_made_name(node.id, name))) current = *value;
    }

    void copy_nodes(const Level& level)
    {
        for (const PlacedNode& placed : level.nodes) {
            if (!placed.is_group) result_.document.root.nodes.push_back(copy_of(level, placed));
            else if (NodeId copy = copy_of({&level, placed.node.id})) result_.stand_ins.emplace(placed.node.id, copy);
            if (placed.inside) copy_nodes(*placed.inside);
        }
    }

    Node copy_of(const Level& level, const PlacedNode& placed) const
    {
        Node copy = placed.node;
        copy.id = placed.copy;
        copy.inputs.clear();
        std::set<std::string> sockets;
        for (const auto& [socket, source] : placed.node.inputs) sockets.insert(socket);
        if (level.group)
            for (const Exposed& exposed : level.group->exposed)
                if (exposed.node == placed.node.id) sockets.insert(exposed.socket);
        for (const std::string& socket : sockets)
            if (NodeId source = copy_of(wired_to(level, placed, socket))) copy.inputs.emplace_back(socket, source);
        return copy;
    }

    // The copy that stands for a source: through the outputs of groups, and past muted ones.
    NodeId copy_of(Source source) const
    {
        while (source.node) {
            const PlacedNode* placed = source.level->find(source.node);
            if (!placed) return {};
            if (!placed->is_group) return placed->copy;
            if (placed->inside) source = {placed->inside.get(), placed->inside->group->output};
            else source = placed->node.muted ? passed_on(*source.level, *placed) : Source{};
        }
        return {};
    }

    Source passed_on(const Level& level, const PlacedNode& placed) const
    {
        const NodeType* type = library_->type(placed.node.type);
        if (!type || !type->is_field() || type->inputs.empty() || !carries_field(type->inputs.front().kind)) return {};
        int given = dimension_of(type->inputs.front().kind), wanted = dimension_of(type->output);
        if (given && wanted && given != wanted) return {};
        return wired_to(level, placed, type->inputs.front().name);
    }

    const Document& document_;
    std::shared_ptr<const Library> library_;
    std::int64_t next_id_;
    std::size_t visited_ = 0;
    Level scene_;
    Expansion result_;
};

}  // namespace

Expansion expanded(const Document& document, const Library& library) { return Expander(document, library).expand(); }

std::vector<NodeId> path_of(const std::vector<InnerCopy>& copies, NodeId node)
{
    auto found = std::lower_bound(copies.begin(), copies.end(), node,
                                  [](const InnerCopy& inner, NodeId wanted) { return inner.copy < wanted; });
    if (found != copies.end() && found->copy == node) return found->path;
    return {node};
}

NodeId shown_on(const std::vector<NodeId>& path, const Graph& graph)
{
    for (NodeId id : path)
        if (graph.find(id)) return id;
    return {};
}

}  // namespace fieldwright::graph
