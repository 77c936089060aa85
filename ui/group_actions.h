// What hands do with groups: the steps behind commands and menus, and the way into groups.
#pragma once

#include "ui/frame_context.h"

namespace fieldwright::ui {

// The name of the group whose inside the canvas shows, empty for the scene; a way that no longer exists is cut.
std::string shown_group(const graph::Document& document, ViewState& view);
// The scene as it was seen before any group was opened.
void close_groups(ViewState& view);
// The problems as the graph on the canvas shows them: about the first of its nodes on the way to where they are.
std::vector<graph::Problem> shown_problems(std::vector<graph::Problem> problems, const graph::Graph& shown);

void group_selected(FrameContext& frame);
void ungroup_active(FrameContext& frame);
void make_active_unique(FrameContext& frame);
void use_as_output(FrameContext& frame, graph::NodeId node);
void save_active_group(FrameContext& frame);
void delete_unused_groups(FrameContext& frame);
bool is_group(const Draft& draft, graph::NodeId node);

}  // namespace fieldwright::ui
