// Nodes apart from a scene: what the clipboard holds as JSON text, and the edits that put them into a document again.
#pragma once

#include "graph/edits.h"

namespace fieldwright::graph {

inline constexpr std::string_view fragment_format = "fieldwright-nodes";
inline constexpr int fragment_version = 1;

struct Fragment {
    std::vector<Node> nodes;     // sorted by id; `inputs` are the wires among them
    std::vector<Wire> incoming;  // from nodes that are not among them
    std::vector<OwnType> own_types;
    std::vector<Group> groups;  // that they are of, however deep; sorted by name
};

// The clipboard's text: {"format": "fieldwright-nodes", "version": 1, "types": {...}, "groups": {...}, "nodes": {...}}, as
// in scene files.
std::string write_fragment(const std::vector<Node>& nodes, const std::vector<OwnType>& own_types = {},
                           const std::vector<Group>& groups = {});
// As strict and limited as scene files. Nodes of unknown type are left out. Throws Failure{3, ...}.
Fragment read_fragment(std::string_view text, const Library& library, std::string_view name = "clipboard");

// Empty when there is nothing to copy: nodes of unknown type stay where they are.
std::string copy_nodes(const Document& document, const Library& library, const std::set<NodeId>& nodes);

// What was pasted, in the order of the copied ids; or why nothing was.
struct Pasted {
    std::vector<NodeId> nodes;
    Refusal refusal;
};
enum class Incoming { drop, keep };  // wires from outside, where their source is in the document and fits

// One step for undo. The left upper corner of the nodes comes to `position`. A second output is left out. Own types
// come along, under another name where theirs is taken; the library of the document is another one then.
Pasted paste_nodes(Document& document, const Library& library, std::string_view text, glm::vec2 position,
                   Incoming incoming = Incoming::drop);
Pasted duplicate_nodes(Document& document, const Library& library, const std::set<NodeId>& nodes, glm::vec2 offset_px,
                       Incoming incoming = Incoming::drop);

}  // namespace fieldwright::graph
