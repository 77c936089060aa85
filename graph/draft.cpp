// Steps of a compound edit.
#include "graph/draft.h"

#include "graph/groups.h"
#include "graph/json.h"
#include "graph/limits.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::graph {
namespace {

Refusal add_error(const Document& document, const Library& library, std::string_view name, glm::vec2 position)
{
    const NodeType* type = library.type(name);
    if (!type) return "there is no node type " + in_quotes(name);
    if (node_count(document) >= node_limit) return "a scene has at most " + std::to_string(node_limit) + " nodes";
    if (!std::isfinite(position.x) || !std::isfinite(position.y)) return "a node's position must be finite";
    if (is_output(*type) && !document.entered.empty())
        return "a group gives what one of its nodes gives; it has no output node";
    if (const Group* group = group_of(document, name); group && contains(document, group->name, document.entered))
        return "a group cannot contain itself";
    if (is_output(*type) && shown_output(document, library))
        return "a scene has one output, and this one has it already";
    return std::nullopt;
}

}  // namespace

void Draft::refuse(Refusal refusal)
{
    if (!refusal_) refusal_ = std::move(refusal);
}

NodeId Draft::add(std::string_view type, glm::vec2 position)
{
    if (!refusal_) refusal_ = add_error(draft_, library_, type, position);
    return refusal_ ? NodeId{} : add_node(draft_, library_, type, position);
}

NodeId Draft::append(NodeId source, std::string_view type_name)
{
    if (refusal_) return {};
    NodeId added = add(type_name, node(source).position + glm::vec2(column_px, 0));
    if (added) wire(source, added, field_inputs(*library_.type(type_name)).front());
    return added;
}

void Draft::wire(NodeId source, NodeId target, std::string_view socket)
{
    if (!refusal_) wires_.push_back({source, target, std::string(socket)});
}

void Draft::hand_over(std::span<const Wire> readers, NodeId heir)
{
    if (refusal_) return;
    for (const Wire& reader : readers)
        if (node(reader.target).unknown_source.empty()) wire(heir, reader.target, reader.socket);
}

void Draft::hand_over_output(NodeId before, NodeId heir)
{
    Group* group = find_group(draft_, draft_.entered);
    if (!refusal_ && group && group->output == before) group->output = heir;
}

void Draft::set(NodeId node, std::string_view parameter, Value value)
{
    if (!refusal_) refusal_ = set_parameter(draft_, library_, node, parameter, std::move(value));
}

void Draft::make_room(NodeId id, const Readers& all_readers, std::span<const Wire> readers)
{
    if (refusal_) return;
    float begin = node(id).position.x, nearest = begin + column_px;
    std::vector<NodeId> stack;
    for (const Wire& reader : readers) {
        stack.push_back(reader.target);
        // What lies left of where the wire comes from is not in the way.
        float x = node(reader.target).position.x;
        if (x > begin - column_px) nearest = std::min(nearest, x);
    }
    glm::vec2 shift(begin + column_px - nearest, 0);
    if (!(shift.x > 0)) return;
    for (std::set<NodeId> seen; !stack.empty();) {
        NodeId next = stack.back();
        stack.pop_back();
        if (!seen.insert(next).second) continue;
        if (node(next).unknown_source.empty()) refuse(move_node(draft_, next, node(next).position + shift));
        for (const Wire& reader : all_readers.of(next)) stack.push_back(reader.target);
    }
}

void Draft::make_wires()
{
    if (!refusal_) refusal_ = connect_all(draft_, library_, wires_);
    wires_.clear();
}

Placed Draft::finish(NodeId node)
{
    make_wires();
    if (refusal_) return {{}, refusal_};
    original_ = std::move(draft_);
    return {node, std::nullopt};
}

}  // namespace fieldwright::graph
