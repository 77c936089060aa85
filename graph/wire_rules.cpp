// Kinds and dimensions of wires.
#include "graph/wire_rules.h"

#include "graph/json.h"

#include <algorithm>
#include <numeric>

namespace fieldwright::graph {
namespace {

bool is_vector(SocketKind kind) { return kind == SocketKind::vec3 || kind == SocketKind::colour; }

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "`" : ", `") + name + "`";
    return text.empty() ? "none" : text;
}

}  // namespace

bool carries_field(SocketKind kind)
{
    return kind == SocketKind::field2d || kind == SocketKind::field3d || kind == SocketKind::field_any;
}

// Fields feed fields, numbers fill vectors, directions and colours are both three numbers.
bool kinds_fit(SocketKind from, SocketKind to)
{
    if (from == SocketKind::none) return false;
    if (carries_field(from)) return carries_field(to);
    if (from == SocketKind::number && (to == SocketKind::vec2 || is_vector(to))) return true;
    return from == to || (is_vector(from) && is_vector(to));
}

int dimension_of(SocketKind kind) { return kind == SocketKind::field2d ? 2 : kind == SocketKind::field3d ? 3 : 0; }

WireRules::WireRules(const Graph& graph, const Library& library, Wording wording)
    : graph_(graph), wording_(wording), parent_(graph.nodes.size()), dimension_(graph.nodes.size(), 0)
{
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const Node& node : graph.nodes) {
        types_.push_back(library.type(node.type));
        if (types_.back()) dimension_[types_.size() - 1] = dimension_of(types_.back()->output);
    }
}

Refusal kind_error(const WireEnd& from, const WireEnd& to, std::string_view socket_name, Wording wording)
{
    if (!to.type) return std::nullopt;
    const Socket* socket = to.type->input(socket_name);
    std::string target = named(wording, *to.node, to.type), input = named(wording, to.type, socket_name);
    if (!socket)
        return target + (wording == Wording::file ? " has no socket " : " has no input ") + input +
               (wording == Wording::file ? "; its sockets are " + socket_names(*to.type) : "");
    if (!from.type || kinds_fit(from.type->output, socket->kind)) return std::nullopt;
    return named(wording, *from.node, from.type) + " gives " + kind_named(wording, from.type->output) +
           " and cannot feed " + input + " of " + target + ", which takes " + kind_named(wording, socket->kind);
}

Refusal dimension_error(const WireEnd& from, int given, const WireEnd& to, int taken, std::string_view socket,
                        Wording wording)
{
    if (!given || !taken || given == taken) return std::nullopt;
    return named(wording, *from.node, from.type) + " gives " + kind_named(wording, SocketKind::field_any, given) +
           " and cannot feed " + named(wording, to.type, socket) + " of " + named(wording, *to.node, to.type) +
           ", which takes " + kind_named(wording, SocketKind::field_any, taken) + "; put " +
           (given == 2 ? "an extrude or a revolve" : "a slice") + " between";
}

Refusal WireRules::add(NodeId source, NodeId target, std::string_view socket)
{
    int from = index_of(source), to = index_of(target);
    if (from < 0) return "there is no node " + std::to_string(source.number);
    if (to < 0) return "there is no node " + std::to_string(target.number);
    WireEnd source_end = end(from), target_end = end(to);
    if (Refusal refusal = kind_error(source_end, target_end, socket, wording_)) return refusal;
    if (!source_end.type || !target_end.type || !source_end.type->is_field()) return std::nullopt;
    return join(from, to, *target_end.type->input(socket));
}

Refusal WireRules::join(int source, int target, const Socket& socket)
{
    bool fixed_source = types_[static_cast<std::size_t>(source)]->output != SocketKind::field_any;
    bool fixed_target = socket.kind != SocketKind::field_any;
    int from = group(source), to = group(target);
    int given = dimension_[static_cast<std::size_t>(from)];
    int taken = fixed_target ? dimension_of(socket.kind) : dimension_[static_cast<std::size_t>(to)];
    if (Refusal refusal = dimension_error(end(source), given, end(target), taken, socket.name, wording_))
        return refusal;
    if (!fixed_source && !fixed_target) parent_[static_cast<std::size_t>(to)] = from;
    if (!fixed_source) dimension_[static_cast<std::size_t>(from)] = given ? given : taken;
    else if (!fixed_target) dimension_[static_cast<std::size_t>(to)] = given;
    return std::nullopt;
}

Refusal WireRules::add_all(NodeId except_target, std::string_view except_socket)
{
    for (const Node& node : graph_.nodes)
        for (const auto& [socket, source] : node.inputs) {
            if (node.id == except_target && socket == except_socket) continue;
            if (Refusal refusal = add(source, node.id, socket)) return refusal;
        }
    return std::nullopt;
}

int WireRules::dimension(NodeId node)
{
    int index = index_of(node);
    return index < 0 ? 0 : dimension_[static_cast<std::size_t>(group(index))];
}

WireEnd WireRules::end(int index) const
{
    auto at = static_cast<std::size_t>(index);
    return {&graph_.nodes[at], types_[at]};
}

int WireRules::index_of(NodeId id) const
{
    const Node* node = graph_.find(id);
    return node ? static_cast<int>(node - graph_.nodes.data()) : -1;
}

int WireRules::group(int index)
{
    auto at = static_cast<std::size_t>(index);
    while (parent_[at] != static_cast<int>(at)) {
        parent_[at] = parent_[static_cast<std::size_t>(parent_[at])];
        at = static_cast<std::size_t>(parent_[at]);
    }
    return static_cast<int>(at);
}

std::string described(const Node& node)
{
    return "node " + std::to_string(node.id.number) + " (" + in_quotes(node.type) + ")";
}

std::string socket_names(const NodeType& type)
{
    std::vector<std::string> names;
    for (const Socket& socket : type.inputs) names.push_back(socket.name);
    return joined(names);
}

std::string parameter_names(const NodeType& type)
{
    std::vector<std::string> names;
    for (const Parameter& parameter : type.parameters)
        if (parameter.kind != ParameterKind::material) names.push_back(parameter.name);
    return joined(names);
}

std::vector<NodeId> find_cycle(const Graph& graph)
{
    enum class Mark : char { fresh, open, done };
    struct Step {
        std::size_t node, input;
    };
    std::vector<Mark> marks(graph.nodes.size(), Mark::fresh);
    std::vector<Step> path;  // from a node up to what it is made of
    for (std::size_t start = 0; start < graph.nodes.size(); ++start) {
        if (marks[start] == Mark::fresh) path.push_back({start, 0}), marks[start] = Mark::open;
        while (!path.empty()) {
            Step& step = path.back();
            const Node& node = graph.nodes[step.node];
            if (step.input == node.inputs.size()) {
                marks[step.node] = Mark::done;
                path.pop_back();
                continue;
            }
            const Node* source = graph.find(node.inputs[step.input++].second);
            if (!source) continue;
            auto index = static_cast<std::size_t>(source - graph.nodes.data());
            if (marks[index] == Mark::open) {
                std::vector<NodeId> cycle;
                for (auto it = path.rbegin(); cycle.empty() || cycle.back() != source->id; ++it)
                    cycle.push_back(graph.nodes[it->node].id);
                return cycle;
            }
            if (marks[index] == Mark::fresh) path.push_back({index, 0}), marks[index] = Mark::open;
        }
    }
    return {};
}

std::string cycle_text(const std::vector<NodeId>& cycle)
{
    std::string text;
    for (std::size_t i = 0; i < cycle.size() && i < 8; ++i) text += std::to_string(cycle[i].number) + " -> ";
    return text + (cycle.size() > 8 ? "... -> " : "") + std::to_string(cycle.front().number);
}

}  // namespace fieldwright::graph
