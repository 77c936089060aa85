// What gestures on the canvas do to the document: each one step with a name, done whole or not at all.
#pragma once

#include "ui/canvas_layout.h"
#include "ui/frame_context.h"

#include "graph/compose.h"

namespace fieldwright::ui {

struct InputName;
struct AddPlace;
struct MovingWires;

void move_selection(FrameContext& frame, glm::vec2 by);
// The one selected node could be put into the wire to an input: nothing reads it yet, and it fits.
bool can_insert(const Draft& draft, graph::NodeId node, graph::NodeId target, const std::string& socket);
void move_onto_wire(FrameContext& frame, glm::vec2 by, graph::NodeId target, const std::string& socket);
// Their inputs read the target; nothing when there is none.
graph::Refusal move_wires(graph::Document& document, const graph::Library& library, const MovingWires& wires);
void cut_wires(FrameContext& frame, const std::vector<InputName>& inputs);
void break_wires(FrameContext& frame, const Hover& pin);  // all of a pin
// Where a loose wire begins.
glm::vec2 loose_end_pin(const CanvasLayout& layout, const graph::LooseEnd& end);

// Adds a node where the add menu was opened, and selects it. NodeId{} when refused.
graph::NodeId add_at(FrameContext& frame, const graph::NodeType& type, const AddPlace& place);

}  // namespace fieldwright::ui
