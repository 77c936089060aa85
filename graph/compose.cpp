// Compound edits, each tried on a draft.
#include "graph/compose.h"

#include "graph/draft.h"
#include "graph/groups.h"
#include "graph/json.h"
#include "graph/known_types.h"
#include "graph/wire_rules.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::graph {
namespace {

Placed refusal(std::string sentence) { return {{}, std::move(sentence)}; }

std::string no_type(std::string_view name) { return "there is no node type " + in_quotes(name); }
std::string no_node(NodeId id) { return "there is no node " + std::to_string(id.number); }

std::string no_input_for(const NodeType& type, const std::string& source, const Offer& offer)
{
    return "no free input of " + titled(type.title) + " takes " +
           kind_named(Wording::titles, offer.kind, offer.dimension) + ", which " + source + " gives";
}

// The output and its input, both made when missing.
struct OutputInput {
    NodeId node;
    std::string socket;
};

NodeId output_of(Draft& draft, glm::vec2 position)
{
    const Node* shown = shown_output(draft.document(), draft.library());
    return shown ? shown->id : draft.add(known_types::output, position);
}

// An unwired side of a union that only the output shows.
std::optional<Wire> free_side(const Draft& draft, NodeId shown)
{
    Readers readers(draft.document().root);
    for (std::vector<NodeId> stack = {shown}; !stack.empty();) {
        const Node& node = draft.node(stack.back());
        stack.pop_back();
        const NodeType* type = draft.library().type(node.type);
        if (!type || node.type != known_types::union_of_two || node.muted || readers.of(node.id).size() != 1) continue;
        for (const std::string& side : field_inputs(*type)) {
            if (!node.input(side)) return Wire{{}, node.id, side};
            stack.push_back(node.input(side));
        }
    }
    return std::nullopt;
}

// A union between what the output shows and the output; it stands where the output stood when there is no room before.
void join_by_union(Draft& draft, NodeId shown, NodeId field, const OutputInput& output)
{
    glm::vec2 place = draft.node(output.node).position;
    float missing = 2 * column_px - (place.x - draft.node(shown).position.x);
    if (missing > 0 && missing <= 2 * column_px) place.x += missing;
    draft.refuse(move_node(draft.document(), output.node, place));
    NodeId both = draft.add(known_types::union_of_two, place - glm::vec2(column_px, 0));
    if (!both) return;
    std::vector<std::string> sides = field_inputs(*draft.library().type(known_types::union_of_two));
    draft.wire(shown, both, sides[0]);
    draft.wire(field, both, sides[1]);
    draft.wire(both, output.node, output.socket);
}

// Inside a group, what it gives is what is shown.
void join_group(Draft& draft, NodeId field, Group& group)
{
    const Node* shown = draft.document().root.find(group.output);
    const NodeType* type = shown ? draft.library().type(shown->type) : nullptr;
    if (!type) group.output = field;
    if (!type || !type->is_field()) return;
    glm::vec2 place = glm::max(shown->position, draft.node(field).position) + glm::vec2(column_px, 0);
    NodeId both = draft.add(known_types::union_of_two, place);
    if (!both) return;
    std::vector<std::string> sides = field_inputs(*draft.library().type(known_types::union_of_two));
    draft.wire(group.output, both, sides[0]);
    draft.wire(field, both, sides[1]);
    group.output = both;
}

void join_output(Draft& draft, NodeId field)
{
    if (draft.refused()) return;
    if (Group* group = find_group(draft.document(), draft.document().entered)) return join_group(draft, field, *group);
    NodeId output = output_of(draft, draft.node(field).position + glm::vec2(column_px, 0));
    if (!output) return;
    std::string socket = field_inputs(*draft.library().type(draft.node(output).type)).front();
    NodeId shown = draft.node(output).input(socket);
    if (!shown) draft.wire(field, output, socket);
    else if (std::optional<Wire> side = free_side(draft, shown)) draft.wire(field, side->target, side->socket);
    else join_by_union(draft, shown, field, {output, socket});
}

// Nothing reads an output: what is put after it goes before it.
Placed insert_before_output(Document& document, const Library& library, const NodeType& type, const Node& output)
{
    std::string socket = field_inputs(*library.type(output.type)).front();
    Draft draft(document, library);
    NodeId added = draft.add(type.name, output.position - glm::vec2(column_px, 0));
    if (!type.is_field() || field_inputs(type).empty())
        return refusal("nothing reads " + titled(node_title(output, library.type(output.type))) + "; select a shape");
    if (NodeId shown = output.input(socket)) draft.wire(shown, added, field_inputs(type).front());
    draft.wire(added, output.id, socket);
    return draft.finish(added);
}

// What the two are made of, themselves included.
std::set<NodeId> made_of(const Graph& graph, std::initializer_list<NodeId> roots)
{
    std::set<NodeId> seen;
    for (std::vector<NodeId> stack(roots); !stack.empty();) {
        NodeId id = stack.back();
        stack.pop_back();
        if (!seen.insert(id).second) continue;
        for (const auto& [socket, source] : graph.find(id)->inputs) stack.push_back(source);
    }
    return seen;
}

// The readers of both that read neither from within, where a wire back would close a cycle.
std::vector<Wire> outer_readers(const Graph& graph, const Readers& readers, NodeId first, NodeId second)
{
    std::set<NodeId> inner = made_of(graph, {first, second});
    std::vector<Wire> outer;
    for (NodeId side : {first, second})
        for (const Wire& reader : readers.of(side))
            if (!inner.contains(reader.target)) outer.push_back(reader);
    return outer;
}

// The unions among the readers that read both.
std::set<NodeId> unions_of(const Document& document, std::span<const Wire> readers, NodeId first, NodeId second)
{
    std::set<NodeId> unions;
    for (const Wire& reader : readers) {
        const Node& node = *document.root.find(reader.target);
        auto reads = [&](NodeId side) {
            return std::any_of(node.inputs.begin(), node.inputs.end(),
                               [&](const auto& in) { return in.second == side; });
        };
        if (node.type == known_types::union_of_two && node.unknown_source.empty() && reads(first) && reads(second))
            unions.insert(node.id);
    }
    return unions;
}

// The node itself decides what it passes on when it goes.
NodeId passed_on(const Node& node, const NodeType* type)
{
    if (!type) return {};
    for (const Socket& socket : type->inputs) {
        bool same = type->is_field() ? carries_field(socket.kind) : kinds_fit(socket.kind, type->output);
        if (NodeId source = node.input(socket.name); same && source) return source;
    }
    return {};
}

// Who is read in place of removed nodes, followed through rows of them.
class Heirs {
public:
    Heirs(const Document& document, const Library& library, const std::set<NodeId>& removed)
        : document_(document), library_(library), removed_(removed)
    {
    }

    NodeId of(NodeId id)
    {
        std::vector<NodeId> row;
        for (; removed_.contains(id) && !known_.contains(id); id = next(id)) row.push_back(id);
        NodeId heir = known_.contains(id) ? known_[id] : id;
        for (NodeId passed : row) known_[passed] = heir;
        return heir;
    }

private:
    NodeId next(NodeId id) const
    {
        const Node& node = *document_.root.find(id);
        return passed_on(node, library_.type(node.type));
    }

    const Document& document_;
    const Library& library_;
    const std::set<NodeId>& removed_;
    std::map<NodeId, NodeId> known_;
};

Refusal dissolve_in(Draft& draft, const Document& before, const std::set<NodeId>& nodes)
{
    Heirs heirs(before, draft.library(), nodes);
    if (Refusal missing = remove_nodes(draft.document(), nodes)) return missing;
    for (const Node& node : before.root.nodes)
        for (const auto& [socket, source] : node.inputs)
            if (nodes.contains(source) && !nodes.contains(node.id) && node.unknown_source.empty())
                draft.wire(heirs.of(source), node.id, socket);
    for (NodeId id : nodes) draft.hand_over_output(id, heirs.of(id));
    return std::nullopt;
}

// The nodes of a set that may be changed; or why there are none.
Refusal changeable(const Document& document, const std::set<NodeId>& nodes, std::vector<NodeId>& found)
{
    for (NodeId id : nodes) {
        const Node* node = document.root.find(id);
        if (!node) return no_node(id);
        if (node->unknown_source.empty()) found.push_back(id);
    }
    if (found.empty())
        return nodes.empty() ? "nothing is selected"
                             : "nodes of a type this version does not know are kept as they are";
    return std::nullopt;
}

bool is_value(const NodeType& type)
{
    return type.output == SocketKind::number || type.output == SocketKind::vec2 || type.output == SocketKind::vec3 ||
           type.output == SocketKind::colour;
}

// The two inputs that change places; empty when the type has none.
std::vector<std::string> exchangeable(const NodeType& type)
{
    std::vector<std::string> names = field_inputs(type);
    if (is_value(type) && type.inputs.size() >= 2 && type.inputs[0].kind == type.inputs[1].kind)
        names = {type.inputs[0].name, type.inputs[1].name};
    if (names.size() < 2) return {};
    names.resize(2);
    return names;
}

// What a node is united with and with nothing else: a shape that was added a moment ago is united with all the rest, and a
// combiner put on it is meant for both. NodeId{} when there is none.
NodeId union_partner(const Document& document, NodeId node)
{
    Readers readers(document.root);
    std::span<const Wire> read = readers.of(node);
    if (read.size() != 1) return {};
    const Node& reader = *document.root.find(read[0].target);
    if (reader.type != known_types::union_of_two || reader.inputs.size() != 2) return {};
    NodeId partner = reader.inputs[0].second == node ? reader.inputs[1].second : reader.inputs[0].second;
    return partner == node ? NodeId{} : partner;
}

}  // namespace

Placed add_from_menu(Document& document, const Library& library, std::string_view name, glm::vec2 position,
                     const std::vector<NodeId>& selection, std::optional<glm::vec3> place)
{
    const NodeType* type = library.type(name);
    if (!type) return refusal(no_type(name));
    if (is_shape(*type)) return add_primitive_to_output(document, library, name, position, place);
    auto is_field_node = [&](NodeId id) { return carries_field(offer_of(document, library, id).kind); };
    bool on_fields = !selection.empty() && std::all_of(selection.begin(), selection.end(), is_field_node);
    std::size_t inputs = field_inputs(*type).size();
    if (is_operator(*type) && on_fields && selection.size() == 1) {
        NodeId partner = inputs == 2 ? union_partner(document, selection[0]) : NodeId{};
        return partner ? combine(document, library, name, partner, selection[0])
                       : insert_after(document, library, name, selection[0]);
    }
    if (is_operator(*type) && on_fields && selection.size() == 2 && inputs == 2)
        return combine(document, library, name, selection[0], selection[1]);
    return add_alone(document, library, name, position);
}

Placed add_alone(Document& document, const Library& library, std::string_view type, glm::vec2 position)
{
    Draft draft(document, library);
    return draft.finish(draft.add(type, position));
}

Placed add_primitive_to_output(Document& document, const Library& library, std::string_view name, glm::vec2 position,
                               std::optional<glm::vec3> place)
{
    const NodeType* type = library.type(name);
    if (!type) return refusal(no_type(name));
    if (!is_shape(*type)) return refusal(titled(type->title) + " is not a shape; it cannot be shown by itself");
    Draft draft(document, library);
    NodeId shape = draft.add(name, position), last = shape;
    if (type->output == SocketKind::field2d) last = draft.append(last, known_types::extrude);
    if (place && *place != glm::vec3(0)) {
        last = draft.append(last, known_types::translate);
        draft.set(last, known_types::translate_offset, *place);
    }
    join_output(draft, last);
    return draft.finish(shape);
}

Placed add_to_output(Document& document, const Library& library, std::string_view name, glm::vec2 position)
{
    const NodeType* type = library.type(name);
    if (!type) return refusal(no_type(name));
    Draft draft(document, library);
    NodeId added = draft.add(name, position);
    NodeId output = output_of(draft, position + glm::vec2(column_px, 0));
    if (draft.refused()) return draft.finish(added);
    const Socket* socket = nullptr;
    for (const Socket& input : library.type(draft.node(output).type)->inputs)
        if (!carries_field(input.kind) && input.kind == type->output) socket = &input;
    if (!socket) return refusal(titled(type->title) + " is nothing that an output takes beside its shape");
    draft.wire(added, output, socket->name);
    return draft.finish(added);
}

Placed insert_after(Document& document, const Library& library, std::string_view name, NodeId selected)
{
    const NodeType* type = library.type(name);
    const Node* node = document.root.find(selected);
    if (!type) return refusal(no_type(name));
    if (!node) return refusal(no_node(selected));
    const NodeType* node_type = library.type(node->type);
    if (node_type && is_output(*node_type)) return insert_before_output(document, library, *type, *node);
    Offer offer = offer_of(document, library, selected);
    const Socket* socket = first_input_for(*type, offer);
    if (!socket) return refusal(no_input_for(*type, titled(title_of(*node, library)), offer));
    Readers readers(document.root);
    Draft draft(document, library);
    NodeId added = draft.add(name, node->position + glm::vec2(column_px, 0));
    draft.wire(selected, added, socket->name);
    if (!is_output(*type)) draft.hand_over(readers.of(selected), added);
    draft.hand_over_output(selected, added);
    draft.make_room(added, readers, readers.of(selected));
    return draft.finish(added);
}

Placed combine(Document& document, const Library& library, std::string_view name, NodeId first, NodeId second)
{
    const NodeType* type = library.type(name);
    if (!type) return refusal(no_type(name));
    for (NodeId side : {first, second})
        if (!document.root.find(side)) return refusal(no_node(side));
    if (first == second) return refusal("two different nodes are combined; select another one too");
    std::vector<std::string> sides = field_inputs(*type);
    if (sides.size() < 2) return refusal(titled(type->title) + " does not combine two shapes");
    Readers readers(document.root);
    std::vector<Wire> outer = outer_readers(document.root, readers, first, second);
    std::set<NodeId> unions = unions_of(document, outer, first, second);
    glm::vec2 a = document.root.find(first)->position, b = document.root.find(second)->position;
    Draft draft(document, library);
    NodeId added = draft.add(name, {std::max(a.x, b.x) + column_px, 0.5f * (a.y + b.y)});
    draft.wire(first, added, sides[0]);
    draft.wire(second, added, sides[1]);
    draft.hand_over(outer, added);
    draft.hand_over_output(first, added);
    draft.hand_over_output(second, added);
    draft.make_room(added, readers, outer);
    draft.make_wires();
    if (draft.refused() || unions.empty()) return draft.finish(added);
    Document whole = draft.document();
    draft.refuse(dissolve_in(draft, whole, unions));
    return draft.finish(added);
}

Refusal insert_on_wire(Document& document, const Library& library, NodeId id, NodeId target, std::string_view socket)
{
    const Node *node = document.root.find(id), *reader = document.root.find(target);
    if (!node) return no_node(id);
    if (!reader) return no_node(target);
    NodeId source = reader->input(socket);
    const NodeType* type = library.type(node->type);
    if (!source)
        return "nothing is wired to " + titled(socket_label(library.type(reader->type), socket)) + " of " +
               titled(title_of(*reader, library));
    if (id == source || id == target) return titled(node_title(*node, type)) + " is an end of this wire already";
    if (!type) return titled(node_title(*node, type)) + " is of a type this version does not know";
    Offer offer = offer_of(document, library, source);
    const Socket* input = first_input_for(*type, offer, node);
    if (!input) return no_input_for(*type, titled(title_of(*document.root.find(source), library)), offer);
    return connect_all(document, library, {{source, id, input->name}, {id, target, std::string(socket)}});
}

Refusal dissolve(Document& document, const Library& library, const std::set<NodeId>& nodes)
{
    if (nodes.empty()) return "nothing is selected";
    Draft draft(document, library);
    draft.refuse(dissolve_in(draft, document, nodes));
    return draft.finish({}).refusal;
}

Refusal swap_inputs(Document& document, const Library& library, NodeId id)
{
    const Node* node = document.root.find(id);
    if (!node) return no_node(id);
    const NodeType* type = library.type(node->type);
    std::vector<std::string> names = type ? exchangeable(*type) : std::vector<std::string>();
    if (names.empty()) return titled(title_of(*node, library)) + " has no two inputs of one kind to swap";
    Draft draft(document, library);
    for (int i = 0; i < 2; ++i) {
        const std::string &from = names[static_cast<std::size_t>(i)], &to = names[static_cast<std::size_t>(1 - i)];
        draft.wire(node->input(from), id, to);
        if (const Value* value = node->parameter(from)) draft.set(id, to, *value);
    }
    return draft.finish(id).refusal;
}

Refusal toggle_muted(Document& document, const std::set<NodeId>& nodes)
{
    std::vector<NodeId> found;
    if (Refusal refused = changeable(document, nodes, found)) return refused;
    bool all = std::all_of(found.begin(), found.end(), [&](NodeId id) { return document.root.find(id)->muted; });
    for (NodeId id : found) set_muted(document, id, !all);
    return std::nullopt;
}

Refusal move_nodes(Document& document, const std::set<NodeId>& nodes, glm::vec2 delta_px)
{
    std::vector<NodeId> found;
    if (Refusal refused = changeable(document, nodes, found)) return refused;
    auto place = [&](NodeId id) { return document.root.find(id)->position + delta_px; };
    for (NodeId id : found)
        if (!std::isfinite(place(id).x) || !std::isfinite(place(id).y)) return "a node's position must be finite";
    for (NodeId id : found) move_node(document, id, place(id));
    return std::nullopt;
}

}  // namespace fieldwright::graph
