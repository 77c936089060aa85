// The rows of a node's parameters and inputs, derived from the declaration of its type.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// One row per parameter. Marks `path`/<parameter> and, within, /x /y /z, /reset, /unwire, /choice/<word>.
void parameter_rows(FrameContext& frame, std::string_view path, graph::NodeId node);
// One row per input that is no parameter: fields, camera, sky. Marks `path`/input/<socket>.
void input_rows(FrameContext& frame, std::string_view path, graph::NodeId node);
bool has_inputs(const graph::NodeType& type);  // such ones

// A field for the node's name with the title of its type as the hint. Marks `path`.
void node_name_field(FrameContext& frame, std::string_view path, const graph::Node& node, float width_px);
void mute_button(FrameContext& frame, std::string_view path, const graph::Node& node);

}  // namespace fieldwright::ui
