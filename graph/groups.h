// Groups of a document: what they are called as node types, what they contain, and entering one.
#pragma once

#include "graph/document.h"

#include <set>

namespace fieldwright::graph {

inline constexpr std::string_view group_prefix = "group:";  // a group's node type is this and its name
inline constexpr std::string_view group_category = "group";
inline constexpr std::size_t group_depth_limit = 32;  // groups in groups

// The parameter of a group's nodes that holds what is made ready of a writing inside (graph/contours.h) which the group
// lets be set from outside: "12.outlines" for the outlines of the inner node 12. Nobody exposes it; it comes along.
std::string ready_made_name(NodeId inner, std::string_view parameter);
// The inner node and its parameter again; NodeId{} when it is no such name.
std::pair<NodeId, std::string_view> ready_made(std::string_view name);

const Group* find_group(const Document& document, std::string_view name);
Group* find_group(Document& document, std::string_view name);
std::string group_type_name(std::string_view group);
// The group that a node is one of; null when it is none, or the document lacks it.
const Group* group_of(const Document& document, const Node& node);
const Group* group_of(const Document& document, std::string_view type);

// Everything below is asked of documents at rest, but for `contains`.

// The groups that nodes of a graph are of, each once, by name.
std::set<std::string> groups_used_by(const Graph& graph);
// Inner ones before those that use them; those on a cycle are left out.
std::vector<const Group*> inner_first(const Document& document);
// How many nodes of all graphs are of the group.
std::size_t uses_of(const Document& document, std::string_view group);
// Whether `outer` is or uses `inner`, however deep.
bool contains(const Document& document, std::string_view outer, std::string_view inner);
std::size_t node_count(const Document& document);  // of all graphs

// Entered or not.
template <typename AnyDocument, typename Visit>
void for_each_graph(AnyDocument& document, Visit visit)
{
    visit(document.root);
    for (auto& group : document.groups) visit(group.graph);
}
const Graph& scene_graph(const Document& document);  // that of the scene, whatever is entered

// The group's graph changes places with the scene's, so that every edit of `root` works on it. Nothing to do when there
// is no such group.
void enter_group(Document& document, std::string_view group);
void leave_group(Document& document);

// Entered for a block, at rest afterwards.
class Entered {
public:
    Entered(Document& document, std::string_view group) : document_(document) { enter_group(document_, group); }
    ~Entered() { leave_group(document_); }
    Entered(const Entered&) = delete;
    Entered& operator=(const Entered&) = delete;

private:
    Document& document_;
};

// At rest for a block; what was entered is entered again afterwards.
class AtRest {
public:
    explicit AtRest(Document& document) : document_(document), entered_(document.entered) { leave_group(document_); }
    ~AtRest() { enter_group(document_, entered_); }
    AtRest(const AtRest&) = delete;
    AtRest& operator=(const AtRest&) = delete;
    void renamed(std::string_view from, std::string_view to)
    {
        if (entered_ == from) entered_ = to;
    }

private:
    Document& document_;
    std::string entered_;
};

}  // namespace fieldwright::graph
