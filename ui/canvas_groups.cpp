// Groups on the canvas: going in and out, the way there, and what their menu offers.
#include "ui/canvas.h"

#include "ui/context_menu.h"
#include "ui/group_actions.h"
#include "ui/widgets.h"

#include "graph/groups.h"

namespace fieldwright::ui {

using graph::NodeId;

void Canvas::enter(FrameContext& frame, NodeId group_node)
{
    if (!is_group(frame.draft, group_node)) return;
    glide_.stop();
    frame.view.way.push_back({group_node, frame.view.canvas});
    frame.view.selection.clear();
    wanted_.opens_group = true;
}

void Canvas::leave(FrameContext& frame, std::size_t groups_left_open)
{
    std::vector<OpenGroup>& way = frame.view.way;
    if (groups_left_open >= way.size()) return;
    glide_.stop();
    frame.view.canvas = way[groups_left_open].around;
    frame.view.selection.only(way[groups_left_open].node);
    way.resize(groups_left_open);
}

// "Scene > Wheel": where the canvas is; each but the last leads there.
void Canvas::breadcrumbs(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    if (frame.view.way.empty()) return;
    std::vector<std::string> names = {"Scene"};
    {
        graph::AtRest scene(frame.draft.document);
        const graph::Graph* graph = &frame.draft.document.root;
        for (const OpenGroup& open : frame.view.way) {
            const graph::Node* node = graph->find(open.node);
            const graph::Group* group = node ? graph::group_of(frame.draft.document, *node) : nullptr;
            if (!group) break;
            names.push_back(group->name);
            graph = &group->graph;
        }
    }
    ImVec2 corner = ImGui::GetWindowPos();
    ImGui::SetCursorScreenPos({corner.x + theme.padding(), corner.y + theme.padding()});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(4), theme.px(4)});
    for (std::size_t i = 0; i < names.size(); ++i) {
        bool last = i + 1 == names.size();
        if (i) {
            ImGui::SameLine();
            line_text(frame, icon::chevron_right, colour::quiet_text);
            ImGui::SameLine();
        }
        ImGui::PushID(static_cast<int>(i));
        bool pressed = text_button(frame, "way", names[i], 0, last ? colour::text : colour::quiet_text);
        frame.rects.mark("canvas/way/" + std::to_string(i));
        ui::tooltip(frame, last ? "The group that is open" : "Leave the group: go to " + names[i] + " (Escape)");
        ImGui::PopID();
        if (pressed && !last) leave(frame, i);
    }
    ImGui::PopStyleVar();
}

void Canvas::group_entries(FrameContext& frame, const graph::Node& node)
{
    NodeId id = node.id;
    bool inside = !frame.draft.document.entered.empty(), group = is_group(frame.draft, id);
    ImGui::Separator();
    if (group && menu_item(frame, "enter", "Open group", "edit.enter_group")) enter(frame, id);
    if (menu_item(frame, "group", "Group", "edit.group")) group_selected(frame);
    if (group) {
        frame.view.selection.add(id);
        if (menu_item(frame, "ungroup", "Ungroup", "edit.ungroup")) ungroup_active(frame);
        if (menu_item(frame, "unique", "Give it a group of its own", "")) make_active_unique(frame);
        if (menu_item(frame, "save_group", "Save group to my library", "")) save_active_group(frame);
    }
    if (inside && menu_item(frame, "group_output", "Use as group's result", "")) use_as_output(frame, id);
}

}  // namespace fieldwright::ui
