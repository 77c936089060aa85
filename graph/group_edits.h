// Edits of groups. Each is one step for undo and changes nothing when it refuses. Those that take a group's name work on
// documents at rest and on entered ones; those that take nodes work on the graph that is worked on, `Document::root`.
#pragma once

#include "graph/compose.h"
#include "graph/fragment.h"
#include "graph/groups.h"

#include <map>

namespace fieldwright::graph {

// Moves the nodes into a new group and puts a node of it in their place. What is wired into them is exposed; one of them
// at most may be read from outside. `name` is made free.
Placed group_nodes(Document& document, const Library& library, const std::set<NodeId>& nodes,
                   std::string_view name = "Group");
// Puts what is inside in the place of a group node. The group goes when nothing else is of it.
Pasted ungroup(Document& document, NodeId node);
// Gives a group node a group of its own, equal to the one it shared.
Placed make_group_unique(Document& document, NodeId node);

// `socket`: a parameter or field input of the inner node, which nothing inside is wired to. It is called like it.
Refusal expose(Document& document, const Library& library, std::string_view group, NodeId node,
               std::string_view socket);
Refusal hide(Document& document, const Library& library, std::string_view group, std::string_view exposed);
Refusal rename_exposed(Document& document, std::string_view group, std::string_view exposed, std::string_view name);
Refusal describe_exposed(Document& document, std::string_view group, std::string_view exposed, std::string_view help);
// To another place in the order; `by`: -1 up, 1 down.
Refusal move_exposed(Document& document, const Library& library, std::string_view group, std::string_view exposed,
                     int by);
Refusal set_group_output(Document& document, const Library& library, std::string_view group, NodeId node);
Refusal rename_group(Document& document, std::string_view group, std::string_view name);
Refusal delete_group(Document& document, std::string_view group);  // refused while nodes are of it

// Brings a group's groups and those it needs into the document: one that is there already, equal but for the ids of its
// nodes, is shared; another of the same name makes the new one take a free name. Returns the names given, by the old ones.
struct Imported {
    std::map<std::string, std::string> names;
    Refusal refusal;
};
Imported import_groups(Document& document, const std::vector<Group>& groups);
// A group and all that it needs, sorted by name.
std::vector<Group> with_inner_groups(const Document& document, const std::set<std::string>& names);

// A group by itself as a fragment's text, for a user's library: one node of it, and all that it needs.
std::string saved_group_text(const Document& document, const Library& library, std::string_view group);
// What such a text holds: the group's name and all groups. Failure 3.
struct SavedGroupText {
    std::string name;
    std::vector<Group> groups;
    NodeType type;  // of the group
};
SavedGroupText read_saved_group(std::string_view text, const Library& library, std::string_view file_name);
// As add_from_menu, after the group was brought into the document.
Placed add_saved_group(Document& document, const Library& library, std::string_view text, glm::vec2 position,
                       const std::vector<NodeId>& selection);

// After edits inside a group: brings the nodes of groups whose interface is another than in `library` up to date. Returns
// the library of the document as it is then.
std::shared_ptr<const Library> settle_groups(Document& document, const Library& library);

}  // namespace fieldwright::graph
