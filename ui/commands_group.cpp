// Commands on groups, in the Edit menu.
#include "ui/canvas.h"
#include "ui/commands.h"
#include "ui/group_actions.h"
#include "ui/keys.h"

namespace fieldwright::ui {
namespace {

graph::NodeId active(const CommandContext& context) { return context.frame.view.selection.active(); }
bool active_is_group(const CommandContext& context) { return is_group(context.frame.draft, active(context)); }
bool is_inside(const CommandContext& context) { return !context.frame.view.way.empty(); }
bool has_selection(const CommandContext& context) { return !context.frame.view.selection.empty(); }

// One key goes in and out, as there is only one of both to be done; where there is neither, it adds.
void enter_or_leave(CommandContext& context)
{
    FrameContext& frame = context.frame;
    frame.view.panes.shown = true;
    if (active_is_group(context)) context.canvas.enter(frame, active(context));
    else if (is_inside(context)) context.canvas.leave(frame, frame.view.way.size() - 1);
    else context.canvas.open_add_menu();
}

}  // namespace

void append_group_commands(std::vector<Command>& list)
{
    list.push_back({.id = "edit.group",
                    .title = "Group",
                    .menu = "Edit",
                    .help = "Moves the selected nodes into a group, which stands in their place as one node.",
                    .icon = icon::cubes,
                    .shortcuts = {{.key = 'G', .control = true}},
                    .separator = true,
                    .enabled = has_selection,
                    .run = [](CommandContext& context) { group_selected(context.frame); }});
    list.push_back({.id = "edit.ungroup",
                    .title = "Ungroup",
                    .menu = "Edit",
                    .help = "Puts what is inside the active group in its place.",
                    .shortcuts = {{.key = 'G', .control = true, .alt = true}},
                    .enabled = active_is_group,
                    .run = [](CommandContext& context) { ungroup_active(context.frame); }});
    list.push_back(
        {.id = "edit.enter_group",
         .title = "Open or leave group",
         .menu = "Edit",
         .help = "Shows what is inside the active group, or leaves the group that is open; else adds a node.",
         .shortcuts = {{.key = key::tab, .scope = Scope::canvas}},
         .enabled =
             [](const CommandContext& context) {
                 return active_is_group(context) || is_inside(context) || context.canvas.hovered();
             },
         .run = enter_or_leave});
    list.push_back({.id = "edit.leave_group",
                    .title = "Leave group",
                    .menu = "Edit",
                    .help = "Shows the graph around the group that is open.",
                    .shortcuts = {{.key = key::escape, .scope = Scope::canvas}},
                    .enabled = is_inside,
                    .run = [](CommandContext& context) {
                        context.canvas.leave(context.frame, context.frame.view.way.size() - 1);
                    }});
    list.push_back({.id = "edit.unique_group",
                    .title = "Give it a group of its own",
                    .menu = "Edit",
                    .help = "The active node gets a copy of its group, to be changed without the others.",
                    .enabled = active_is_group,
                    .run = [](CommandContext& context) { make_active_unique(context.frame); }});
    list.push_back(
        {.id = "edit.save_group",
         .title = "Save group to my library",
         .menu = "Edit",
         .help = "Keeps the active group, or the open one, for every scene: the add menu lists it under My groups.",
         .icon = icon::save,
         .enabled = [](const CommandContext& context) { return active_is_group(context) || is_inside(context); },
         .run = [](CommandContext& context) { save_active_group(context.frame); }});
    list.push_back(
        {.id = "edit.delete_groups",
         .title = "Delete unused groups",
         .menu = "Edit",
         .help = "Removes the groups that no node is of.",
         .enabled = [](const CommandContext& context) { return !context.frame.draft.document.groups.empty(); },
         .run = [](CommandContext& context) { delete_unused_groups(context.frame); }});
}

}  // namespace fieldwright::ui
