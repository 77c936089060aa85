// Rules of groups.
#include "graph/group_rules.h"

#include "graph/json.h"
#include "graph/wire_rules.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

Refusal name_error(const char* whose, std::string_view name)
{
    std::string begin = std::string(whose) + "'s name ";
    if (name.empty()) return begin + "must not be empty";
    if (name.size() > group_name_limit) return begin + "has at most 64 bytes; shorten it";
    if (!is_utf8(name)) return begin + "must be UTF-8 text";
    if (name.front() == ' ' || name.back() == ' ') return begin + "must not begin or end with a space";
    auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; };
    if (std::any_of(name.begin(), name.end(), is_control)) return begin + "must be one line of plain text";
    return std::nullopt;
}

template <typename Taken>
std::string free_name(std::string_view wished, Taken taken)
{
    std::string base(wished.substr(0, group_name_limit - 6));
    while (!base.empty() && (!is_utf8(base) || base.back() == ' ')) base.pop_back();
    std::string name = base;
    for (int number = 2; taken(name); ++number) name = base + " " + std::to_string(number);
    return name;
}

Refusal group_error(const Group& group, const Library& library)
{
    if (group.exposed.size() > exposed_limit) return "it exposes more than 256 parameters";
    for (auto exposed = group.exposed.begin(); exposed != group.exposed.end(); ++exposed) {
        if (Refusal refusal = exposed_name_error(exposed->name)) return refusal;
        auto is_same = [&](const Exposed& other) { return other.name == exposed->name; };
        if (std::any_of(group.exposed.begin(), exposed, is_same))
            return "it exposes two things as " + in_quotes(exposed->name);
        if (Refusal refusal = exposed_error(*exposed, group.graph, library)) return refusal;
    }
    return group_output_error(group.output, group.graph, library);
}

}  // namespace

Refusal group_name_error(std::string_view name)
{
    if (name == "root") return "a group is not called `root`, which is the scene's own graph; choose another name";
    return name_error("a group", name);
}

Refusal exposed_name_error(std::string_view name) { return name_error("an exposed parameter", name); }

Refusal exposed_error(const Exposed& exposed, const Graph& graph, const Library& library)
{
    const Node* node = graph.find(exposed.node);
    if (!node) return "there is no node " + std::to_string(exposed.node.number) + " in the group";
    const NodeType* type = library.type(node->type);
    if (!type || type->parameter(exposed.socket) || type->input(exposed.socket)) return std::nullopt;
    return described(*node) + " has no parameter or input " + in_quotes(exposed.socket) + "; its parameters are " +
           parameter_names(*type);
}

Refusal group_output_error(NodeId output, const Graph& graph, const Library& library)
{
    if (!output) return std::nullopt;
    const Node* node = graph.find(output);
    if (!node) return "there is no node " + std::to_string(output.number) + " in the group";
    const NodeType* type = library.type(node->type);
    if (type && (type->output == SocketKind::none || type->category == "output"))
        return described(*node) + " gives nothing that a group could give";
    return std::nullopt;
}

Refusal groups_error(const Document& document, const Library& library)
{
    if (!document.entered.empty()) return "a group is entered";
    if (document.groups.size() > group_limit) return "a scene has at most 1000 groups";
    auto unordered = [](const Group& a, const Group& b) { return a.name >= b.name; };
    if (std::adjacent_find(document.groups.begin(), document.groups.end(), unordered) != document.groups.end())
        return "the groups are not sorted by name, each once";
    if (inner_first(document).size() != document.groups.size()) return "a group contains itself";
    std::set<NodeId> ids;
    for (const Node& node : document.root.nodes) ids.insert(node.id);
    for (const Group& group : document.groups) {
        if (Refusal refusal = group_name_error(group.name)) return refusal;
        for (const Node& node : group.graph.nodes)
            if (!ids.insert(node.id).second) return "two graphs have a node " + std::to_string(node.id.number);
        if (Refusal refusal = group_error(group, library)) return "group " + in_quotes(group.name) + ": " + *refusal;
    }
    return std::nullopt;
}

std::string free_group_name(const Document& document, std::string_view wished)
{
    return free_name(wished,
                     [&](const std::string& name) { return find_group(document, name) || group_name_error(name); });
}

std::string free_exposed_name(const Group& group, std::string_view wished)
{
    return free_name(wished, [&](const std::string& name) {
        return std::any_of(group.exposed.begin(), group.exposed.end(),
                           [&](const Exposed& exposed) { return exposed.name == name; });
    });
}

}  // namespace fieldwright::graph
