// Compound edits: what the editor does to a document in one gesture. Each is one step for undo, is built on
// graph/edits.h, and changes nothing when it refuses. All are O((nodes + wires) log nodes).
#pragma once

#include "graph/edits.h"

namespace fieldwright::graph {

// A new node, to be selected; or why nothing was done.
struct Placed {
    NodeId node;  // NodeId{} when refused
    Refusal refusal;
};

// Canvas distance from one column of nodes to the next, where an edit has to find a place itself.
inline constexpr float column_px = 220;

// Adds what the add menu offers: a shape joins the output, an operator goes after the one selected node, a type with
// two field inputs combines the two selected ones, or takes the place of the union that the one selected node is in;
// anything else stands alone. `place`: where in the world, of shapes.
Placed add_from_menu(Document& document, const Library& library, std::string_view type, glm::vec2 position,
                     const std::vector<NodeId>& selection, std::optional<glm::vec3> place = {});
// A node alone, as add_node, but with the reason when it refuses. A scene has one output.
Placed add_alone(Document& document, const Library& library, std::string_view type, glm::vec2 position);
// A shape (a field without field inputs) that is seen at once: flat ones are extruded, those with a place off the
// origin are translated, and a union joins it to what the output shows, unless one there has a side free. Makes the
// output when there is none.
Placed add_primitive_to_output(Document& document, const Library& library, std::string_view type, glm::vec2 position,
                               std::optional<glm::vec3> place = {});
// A camera or sky that the output uses from now on; makes the output when there is none.
Placed add_to_output(Document& document, const Library& library, std::string_view type, glm::vec2 position);
// The new node reads `node`, and everything that read `node` reads the new one. Before an output, which nothing reads.
Placed insert_after(Document& document, const Library& library, std::string_view type, NodeId node);
// The new node reads both, and everything that read one of them reads the new one; a union that read both goes.
Placed combine(Document& document, const Library& library, std::string_view type, NodeId first, NodeId second);
// The wire to `target`.`socket` leads through `node` instead, by the first unwired input that fits.
Refusal insert_on_wire(Document& document, const Library& library, NodeId node, NodeId target, std::string_view socket);
// Removes nodes and lets their readers read what they passed on: their first wired field input, or of values the first
// wired input of the same kind.
Refusal dissolve(Document& document, const Library& library, const std::set<NodeId>& nodes);
// Exchanges the first two field inputs, or the first two inputs of a value node with their values when they are of one kind.
Refusal swap_inputs(Document& document, const Library& library, NodeId node);

// Of a set, nodes of unknown type stay as they are; refused when nothing else is in it, or one does not exist.
// Unmutes when all are muted, else mutes.
Refusal toggle_muted(Document& document, const std::set<NodeId>& nodes);
Refusal move_nodes(Document& document, const std::set<NodeId>& nodes, glm::vec2 delta_px);

// The end of a wire in the hand: of the output of `node` when `socket` is empty, else of that input.
struct LooseEnd {
    NodeId node;
    std::string socket;
};
// A type that could be wired to a loose end, and the socket of the new node (empty: its output).
struct Fit {
    const NodeType* type;
    std::string socket;
};
// In the library's order; empty when the end does not exist.
std::vector<Fit> fits(const Document& document, const Library& library, const LooseEnd& end);
// Adds a node of one of those types, wired to the end.
Placed add_wired(Document& document, const Library& library, std::string_view type, glm::vec2 position,
                 const LooseEnd& end);

}  // namespace fieldwright::graph
