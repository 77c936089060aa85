// Walking from the output down to a node.
#include "ui/placement.h"

#include "graph/expansion.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

using graph::Node;
using graph::SocketKind;

bool keeps_space(const graph::NodeType& type)
{
    return type.category != "domain" && type.category != "convert" && !type.function("point");
}

template <typename T>
std::optional<T> constant(const Node& node, std::string_view name)
{
    const graph::Value* value = node.parameter(name);
    if (!value || node.input(name) || !std::holds_alternative<T>(*value)) return std::nullopt;
    return std::get<T>(*value);
}

glm::mat3 turned(glm::vec3 angles_deg)
{
    glm::mat4 turn(1);
    for (int axis : {2, 1, 0}) {
        glm::vec3 about(0);
        about[axis] = 1;
        turn = glm::rotate(turn, glm::radians(angles_deg[axis]), about);
    }
    return glm::mat3(turn);
}

// The space of the node's output seen from the world -> that of its inputs.
std::optional<Placement> below(const Placement& place, const Node& node, const graph::NodeType& type)
{
    if (node.muted || keeps_space(type)) return place;
    if (type.name == "translate")
        if (auto offset = constant<glm::vec3>(node, "offset"))
            return Placement{place.linear, place.world_from_node(*offset)};
    if (type.name == "rotate")
        if (auto angles = constant<glm::vec3>(node, "angles"))
            return Placement{place.linear * turned(*angles), place.offset};
    if (type.name == "scale")
        if (auto factor = constant<float>(node, "factor")) return Placement{place.linear * *factor, place.offset};
    return std::nullopt;
}

class Search {
public:
    Search(const graph::Document& document, const graph::Library& library, graph::NodeId wanted)
        : graph_(document.root), library_(library), wanted_(wanted), seen_(graph_.nodes.size())
    {
    }

    std::optional<Placement> run()
    {
        for (const Node& node : graph_.nodes)
            if (node.type == "output") visit(node, {});
        while (!found_ && !open_.empty()) {
            auto [node, place] = open_.back();
            open_.pop_back();
            visit(*node, place);
        }
        return found_;
    }

private:
    void visit(const Node& node, const Placement& place)
    {
        auto index = static_cast<std::size_t>(&node - graph_.nodes.data());
        if (seen_[index]) return;
        seen_[index] = true;
        if (node.id == wanted_) found_ = place;
        const graph::NodeType* type = library_.type(node.type);
        std::optional<Placement> inner = type ? below(place, node, *type) : std::nullopt;
        if (!inner) return;
        // Muted nodes pass their first input on. The first is visited first: it is put on the stack last.
        std::size_t count = node.muted ? std::min<std::size_t>(type->inputs.size(), 1) : type->inputs.size();
        for (std::size_t i = count; i-- > 0;) {
            const graph::Socket& socket = type->inputs[i];
            if (socket.kind == SocketKind::field3d || socket.kind == SocketKind::field_any)
                if (const Node* source = graph_.find(node.input(socket.name))) open_.emplace_back(source, *inner);
        }
    }

    const graph::Graph& graph_;
    const graph::Library& library_;
    graph::NodeId wanted_;
    std::vector<bool> seen_;
    std::vector<std::pair<const Node*, Placement>> open_;
    std::optional<Placement> found_;
};

}  // namespace

std::optional<Placement> placement(const graph::Document& document, const graph::Library& library, graph::NodeId node)
{
    if (document.groups.empty()) return Search(document, library, node).run();
    graph::Document scene = document;
    graph::leave_group(scene);
    graph::Expansion expansion = graph::expanded(scene, library);
    auto stand_in = expansion.stand_ins.find(node);
    return Search(expansion.document, library, stand_in == expansion.stand_ins.end() ? node : stand_in->second).run();
}

Measured placed(const Placement& place, const Measured& box)
{
    Measured world{place.world_from_node(box.centre), glm::vec3(0)};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(place.linear[column][row]) > 1e-6f)
                world.half_size[row] += std::abs(place.linear[column][row]) * box.half_size[column];
    world.half_size = glm::min(world.half_size, glm::vec3(unbounded));
    return world;
}

}  // namespace fieldwright::ui
