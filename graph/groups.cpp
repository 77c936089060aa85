// Look-ups among groups.
#include "graph/groups.h"

#include <algorithm>
#include <cassert>
#include <charconv>

namespace fieldwright::graph {
namespace {

// Which graph a group's nodes are in just now.
const Graph& graph_of(const Document& document, const Group& group)
{
    return group.name == document.entered ? document.root : group.graph;
}

class InnerFirst {
public:
    explicit InnerFirst(const Document& document) : document_(document) {}

    std::vector<const Group*> order()
    {
        for (const Group& group : document_.groups) visit(group, 0);
        return std::move(order_);
    }

private:
    // Whether it is without a cycle.
    bool visit(const Group& group, std::size_t depth)
    {
        if (done_.contains(group.name)) return true;
        if (depth > group_depth_limit || !open_.insert(group.name).second) return false;
        bool good = true;
        for (const std::string& name : groups_used_by(graph_of(document_, group)))
            if (const Group* inner = find_group(document_, name)) good = visit(*inner, depth + 1) && good;
        open_.erase(group.name);
        if (!good) return false;
        done_.insert(group.name);
        order_.push_back(&group);
        return true;
    }

    const Document& document_;
    std::set<std::string_view> done_, open_;
    std::vector<const Group*> order_;
};

}  // namespace

std::string ready_made_name(NodeId inner, std::string_view parameter)
{
    return std::to_string(inner.number) + "." + std::string(parameter);
}

std::pair<NodeId, std::string_view> ready_made(std::string_view name)
{
    NodeId inner;
    auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), inner.number);
    if (error != std::errc() || end == name.data() + name.size() || *end != '.') return {};
    return {inner, name.substr(static_cast<std::size_t>(end - name.data()) + 1)};
}

const Group* find_group(const Document& document, std::string_view name)
{
    auto found = std::lower_bound(document.groups.begin(), document.groups.end(), name,
                                  [](const Group& group, std::string_view wanted) { return group.name < wanted; });
    return found != document.groups.end() && found->name == name ? &*found : nullptr;
}

Group* find_group(Document& document, std::string_view name)
{
    return const_cast<Group*>(find_group(std::as_const(document), name));
}

std::string group_type_name(std::string_view group) { return std::string(group_prefix) + std::string(group); }

const Group* group_of(const Document& document, std::string_view type)
{
    return type.starts_with(group_prefix) ? find_group(document, type.substr(group_prefix.size())) : nullptr;
}

const Group* group_of(const Document& document, const Node& node)
{
    return node.unknown_source.empty() ? group_of(document, node.type) : nullptr;
}

std::set<std::string> groups_used_by(const Graph& graph)
{
    std::set<std::string> names;
    for (const Node& node : graph.nodes)
        if (node.unknown_source.empty() && node.type.starts_with(group_prefix))
            names.insert(node.type.substr(group_prefix.size()));
    return names;
}

std::vector<const Group*> inner_first(const Document& document) { return InnerFirst(document).order(); }

std::size_t uses_of(const Document& document, std::string_view group)
{
    std::string type = group_type_name(group);
    auto uses = [&](const Graph& graph) {
        return static_cast<std::size_t>(std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
            return node.type == type && node.unknown_source.empty();
        }));
    };
    std::size_t count = uses(document.root);
    for (const Group& other : document.groups) count += uses(other.graph);
    return count;
}

bool contains(const Document& document, std::string_view outer, std::string_view inner)
{
    std::set<std::string> seen;
    for (std::vector<std::string> stack = {std::string(outer)}; !stack.empty();) {
        std::string name = std::move(stack.back());
        stack.pop_back();
        if (name == inner) return true;
        const Group* group = find_group(document, name);
        if (!group || !seen.insert(name).second) continue;
        for (const std::string& used : groups_used_by(graph_of(document, *group))) stack.push_back(used);
    }
    return false;
}

std::size_t node_count(const Document& document)
{
    std::size_t count = document.root.nodes.size();
    for (const Group& group : document.groups) count += group.graph.nodes.size();
    return count;
}

const Graph& scene_graph(const Document& document)
{
    const Group* entered = find_group(document, document.entered);
    return entered ? entered->graph : document.root;
}

void enter_group(Document& document, std::string_view name)
{
    assert(document.entered.empty());
    Group* group = find_group(document, name);
    if (!group) return;
    std::swap(document.root, group->graph);
    document.entered = name;
}

void leave_group(Document& document)
{
    if (document.entered.empty()) return;
    Group* group = find_group(document, document.entered);
    assert(group);
    std::swap(document.root, group->graph);
    document.entered.clear();
}

}  // namespace fieldwright::graph
