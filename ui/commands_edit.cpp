// Commands of the Edit menu.
#include "graph/compose.h"
#include "graph/custom_nodes.h"
#include "graph/fragment.h"
#include "graph/layout.h"
#include "ui/canvas.h"
#include "ui/commands.h"
#include "ui/keys.h"
#include "ui/node_geometry.h"

#include <imgui.h>

namespace fieldwright::ui {
namespace {

constexpr glm::vec2 duplicate_offset_px{32, 32};

Selection& selection(const CommandContext& context) { return context.frame.view.selection; }
bool has_selection(const CommandContext& context) { return !selection(context).empty(); }
bool has_active(const CommandContext& context) { return bool(selection(context).active()); }
bool has_nodes(const CommandContext& context) { return !context.frame.draft.document.root.nodes.empty(); }

// Over the canvas and over the picture, where nodes are at hand.
std::vector<Shortcut> over_nodes(std::initializer_list<Shortcut> shortcuts)
{
    std::vector<Shortcut> both;
    for (Scope scope : {Scope::canvas, Scope::viewport})
        for (Shortcut shortcut : shortcuts) {
            shortcut.scope = scope;
            both.push_back(shortcut);
        }
    return both;
}

bool copy(CommandContext& context)
{
    Draft& draft = context.frame.draft;
    std::string text = graph::copy_nodes(draft.document, draft.library, selection(context).as_set());
    if (text.empty()) draft.refusal = "Nodes of a type this program does not know stay where they are.";
    else ImGui::SetClipboardText(text.c_str());
    return !text.empty();
}

void remove_selected(CommandContext& context, const char* step)
{
    Draft& draft = context.frame.draft;
    for (graph::NodeId node : selection(context).nodes())
        if (!draft.done(step, graph::remove_node(draft.document, node))) return;
    selection(context).clear();
}

void show_pasted(CommandContext& context, const char* step, graph::Pasted pasted)
{
    if (context.frame.draft.done(step, pasted.refusal)) selection(context).replace(std::move(pasted.nodes));
}

void paste(CommandContext& context, graph::Incoming incoming)
{
    Draft& draft = context.frame.draft;
    const char* text = ImGui::GetClipboardText();
    show_pasted(context, "Paste",
                graph::paste_nodes(draft.document, draft.library, text ? text : "", context.canvas.cursor_on_canvas(),
                                   incoming));
}

void duplicate(CommandContext& context, graph::Incoming incoming)
{
    Draft& draft = context.frame.draft;
    show_pasted(context, "Duplicate",
                graph::duplicate_nodes(draft.document, draft.library, selection(context).as_set(), duplicate_offset_px,
                                       incoming));
}

std::string step_sentence(const char* verb, const Readings& readings, std::size_t step)
{
    bool there = step > 0 && step < readings.step_names.size();
    return there ? std::string(verb) + ": " + readings.step_names[step] + "." : std::string(verb) + " a step.";
}

void append_history(std::vector<Command>& list, const Readings& readings)
{
    list.push_back({.id = "edit.undo",
                    .title = "Undo",
                    .menu = "Edit",
                    .help = step_sentence("Takes back", readings, readings.step),
                    .icon = icon::undo,
                    .shortcuts = {{.key = 'Z', .control = true, .repeats = true}},
                    .enabled = [](const CommandContext& context) { return context.frame.readings.step > 0; },
                    .run = [](CommandContext& context) { context.frame.requests.push_back(Undo{}); }});
    list.push_back({.id = "edit.redo",
                    .title = "Redo",
                    .menu = "Edit",
                    .help = step_sentence("Makes again", readings, readings.step + 1),
                    .icon = icon::redo,
                    .shortcuts = {{.key = 'Z', .control = true, .shift = true, .repeats = true},
                                  {.key = 'Y', .control = true, .repeats = true}},
                    .enabled =
                        [](const CommandContext& context) {
                            return context.frame.readings.step + 1 < context.frame.readings.step_names.size();
                        },
                    .run = [](CommandContext& context) { context.frame.requests.push_back(Redo{}); }});
}

void append_clipboard(std::vector<Command>& list)
{
    list.push_back({.id = "edit.cut",
                    .title = "Cut",
                    .menu = "Edit",
                    .help = "Copies the selected nodes as text and removes them.",
                    .shortcuts = {{.key = 'X', .control = true}},
                    .separator = true,
                    .enabled = has_selection,
                    .run = [](CommandContext& context) {
                        if (copy(context)) remove_selected(context, "Cut");
                    }});
    list.push_back({.id = "edit.copy",
                    .title = "Copy",
                    .menu = "Edit",
                    .help = "Copies the selected nodes and the wires among them as text.",
                    .icon = icon::copy,
                    .shortcuts = {{.key = 'C', .control = true}},
                    .enabled = has_selection,
                    .run = [](CommandContext& context) { copy(context); }});
    list.push_back({.id = "edit.paste",
                    .title = "Paste",
                    .menu = "Edit",
                    .help = "Adds the copied nodes at the mouse.",
                    .shortcuts = {{.key = 'V', .control = true}},
                    .run = [](CommandContext& context) { paste(context, graph::Incoming::drop); }});
    list.push_back({.id = "edit.paste_with_inputs",
                    .title = "Paste with inputs",
                    .menu = "Edit",
                    .help = "Adds the copied nodes at the mouse, wired to what the copied ones read.",
                    .shortcuts = {{.key = 'V', .control = true, .shift = true}},
                    .run = [](CommandContext& context) { paste(context, graph::Incoming::keep); }});
    list.push_back({.id = "edit.duplicate",
                    .title = "Duplicate",
                    .menu = "Edit",
                    .help = "Adds a second one of each selected node.",
                    .shortcuts = {{.key = 'D', .control = true}, {.key = 'D', .shift = true}},
                    .enabled = has_selection,
                    .run = [](CommandContext& context) { duplicate(context, graph::Incoming::drop); }});
    list.push_back({.id = "edit.duplicate_with_inputs",
                    .title = "Duplicate with inputs",
                    .menu = "Edit",
                    .help = "Adds a second one of each selected node, wired to what the first reads.",
                    .shortcuts = {{.key = 'D', .control = true, .shift = true}},
                    .enabled = has_selection,
                    .run = [](CommandContext& context) { duplicate(context, graph::Incoming::keep); }});
}

void append_removal(std::vector<Command>& list)
{
    list.push_back({.id = "edit.delete",
                    .title = "Delete",
                    .menu = "Edit",
                    .help = "Removes the selected nodes and their wires.",
                    .icon = icon::trash,
                    .shortcuts = over_nodes({{.key = key::del}, {.key = 'X'}, {.key = key::backspace}}),
                    .separator = true,
                    .enabled = has_selection,
                    .run = [](CommandContext& context) { remove_selected(context, "Delete"); }});
    list.push_back({.id = "edit.dissolve",
                    .title = "Dissolve",
                    .menu = "Edit",
                    .help = "Removes the selected nodes and lets what read them read what they read.",
                    .shortcuts = over_nodes({{.key = key::del, .control = true}}),
                    .enabled = has_selection,
                    .run = [](CommandContext& context) {
                        Draft& draft = context.frame.draft;
                        draft.done("Dissolve",
                                   graph::dissolve(draft.document, draft.library, selection(context).as_set()));
                    }});
    list.push_back({.id = "edit.remove_unused_types",
                    .title = "Remove unused code",
                    .menu = "Edit",
                    .help = "Removes the scene's own node types that no node has.",
                    .enabled =
                        [](const CommandContext& context) {
                            return !graph::unused_own_types(context.frame.draft.document).empty();
                        },
                    .run =
                        [](CommandContext& context) {
                            Draft& draft = context.frame.draft;
                            draft.done("Remove unused code", graph::remove_unused_own_types(draft.document));
                        }});
}

void append_node(std::vector<Command>& list)
{
    list.push_back({.id = "edit.mute",
                    .title = "Mute",
                    .menu = "Edit",
                    .help = "Lets the selected nodes pass their input on unchanged, or work again.",
                    .icon = icon::eye_off,
                    .shortcuts = over_nodes({{.key = 'M'}}),
                    .separator = true,
                    .enabled = has_selection,
                    .checked =
                        [](const CommandContext& context) {
                            const graph::Node* node =
                                context.frame.draft.document.root.find(selection(context).active());
                            return node && node->muted;
                        },
                    .run =
                        [](CommandContext& context) {
                            Draft& draft = context.frame.draft;
                            draft.done("Mute", graph::toggle_muted(draft.document, selection(context).as_set()));
                        }});
    list.push_back({.id = "edit.rename",
                    .title = "Rename",
                    .menu = "Edit",
                    .help = "Gives the active node a name of your own.",
                    .icon = icon::pencil,
                    .shortcuts = {{.key = key::f2}},
                    .enabled = has_active,
                    .run = [](CommandContext& context) {
                        context.frame.view.panes.shown = true;
                        context.canvas.begin_rename(selection(context).active());
                    }});
    list.push_back({.id = "edit.swap_inputs",
                    .title = "Swap inputs",
                    .menu = "Edit",
                    .help = "Exchanges the first two inputs of the active node.",
                    .shortcuts = over_nodes({{.key = 'S', .alt = true}}),
                    .enabled = has_active,
                    .run = [](CommandContext& context) {
                        Draft& draft = context.frame.draft;
                        draft.done("Swap inputs",
                                   graph::swap_inputs(draft.document, draft.library, selection(context).active()));
                    }});
}

// The selected nodes, or all when there is no selection of several.
void arrange(CommandContext& context)
{
    Draft& draft = context.frame.draft;
    auto size_px = [&](graph::NodeId id) {
        const graph::Node& node = *draft.document.root.find(id);
        return node_size(node, draft.library.type(node.type));
    };
    std::set<graph::NodeId> nodes = selection(context).as_set();
    if (nodes.size() < 2) nodes.clear();
    draft.done("Lay out nodes", graph::arrange(draft.document, nodes, size_px));
}

void append_selection(std::vector<Command>& list)
{
    list.push_back({.id = "edit.select_all",
                    .title = "Select all",
                    .menu = "Edit",
                    .help = "Selects every node.",
                    .shortcuts = {{.key = 'A', .control = true}},
                    .separator = true,
                    .enabled = has_nodes,
                    .run = [](CommandContext& context) { context.canvas.select_all(context.frame); }});
    list.push_back({.id = "edit.select_none",
                    .title = "Select nothing",
                    .menu = "Edit",
                    .help = "Selects no node.",
                    .shortcuts = {{.key = 'A', .control = true, .shift = true}},
                    .enabled = has_selection,
                    .run = [](CommandContext& context) { selection(context).clear(); }});
    list.push_back({.id = "edit.layout",
                    .title = "Lay out nodes",
                    .menu = "Edit",
                    .help = "Puts the selected nodes, or all, in columns from left to right.",
                    .shortcuts = {{.key = 'L', .control = true}},
                    .separator = true,
                    .enabled = has_nodes,
                    .run = arrange});
}

}  // namespace

void append_edit_commands(std::vector<Command>& list, const Readings& readings)
{
    append_history(list, readings);
    append_clipboard(list);
    append_removal(list);
    append_node(list);
    append_group_commands(list);
    append_selection(list);
}

}  // namespace fieldwright::ui
