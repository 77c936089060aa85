// Commands of the View menu.
#include "ui/canvas.h"
#include "ui/commands.h"
#include "ui/keys.h"
#include "ui/stereo_comfort.h"
#include "ui/viewport.h"
#include "ui/workspaces.h"

#include "graph/words.h"

namespace fieldwright::ui {
namespace {

bool has_camera(const CommandContext& context) { return context.frame.readings.has_camera; }
bool has_nodes(const CommandContext& context) { return !context.frame.draft.document.root.nodes.empty(); }
bool has_selection(const CommandContext& context) { return !context.frame.view.selection.empty(); }

void append_framing(std::vector<Command>& list)
{
    list.push_back({.id = "view.frame_all",
                    .title = "Frame everything",
                    .menu = "View",
                    .help = "Moves the eye until the whole scene is in the viewport.",
                    .icon = icon::expand,
                    .shortcuts = {{.key = key::home, .scope = Scope::viewport}},
                    .separator = true,
                    .run = [](CommandContext& context) { context.viewport.frame_all(context.frame); }});
    list.push_back(
        {.id = "view.frame_selected",
         .title = "Frame the selection",
         .menu = "View",
         .help = "Moves the eye until the selected node's surface fills the viewport.",
         .icon = icon::crosshair,
         .shortcuts = {{.key = 'F', .scope = Scope::viewport}, {.key = key::keypad_decimal, .scope = Scope::viewport}},
         .enabled = has_selection,
         .run = [](CommandContext& context) { context.viewport.frame_selected(context.frame); }});
    list.push_back({.id = "view.frame_all_nodes",
                    .title = "Frame all nodes",
                    .menu = "View",
                    .help = "Moves and zooms the canvas until every node is on it.",
                    .shortcuts = {{.key = key::home, .scope = Scope::canvas}},
                    .enabled = has_nodes,
                    .run = [](CommandContext& context) { context.canvas.frame_all(); }});
    list.push_back(
        {.id = "view.frame_selected_nodes",
         .title = "Frame selected nodes",
         .menu = "View",
         .help = "Moves and zooms the canvas until the selected nodes fill it.",
         .shortcuts = {{.key = 'F', .scope = Scope::canvas}, {.key = key::keypad_decimal, .scope = Scope::canvas}},
         .enabled = has_selection,
         .run = [](CommandContext& context) { context.canvas.frame_selected(); }});
}

struct AxisView {
    const char *id, *title, *help;
    int key;
    bool control;
    int axis, side;
};
constexpr AxisView axis_views[] = {
    {"front", "From the front", "Looks from +z, without perspective.", key::keypad_1, false, 2, 1},
    {"back", "From the back", "Looks from -z, without perspective.", key::keypad_1, true, 2, -1},
    {"right", "From the right", "Looks from +x, without perspective.", key::keypad_3, false, 0, 1},
    {"left", "From the left", "Looks from -x, without perspective.", key::keypad_3, true, 0, -1},
    {"top", "From above", "Looks from +y, without perspective.", key::keypad_7, false, 1, 1},
    {"bottom", "From below", "Looks from -y, without perspective.", key::keypad_7, true, 1, -1},
};

void append_eye(std::vector<Command>& list)
{
    for (const AxisView& view : axis_views)
        list.push_back({.id = std::string("view.") + view.id,
                        .title = view.title,
                        .menu = "View/Point of view",
                        .help = view.help,
                        .shortcuts = {{.key = view.key, .control = view.control, .scope = Scope::viewport}},
                        .run = [axis = view.axis, side = view.side](CommandContext& context) {
                            context.viewport.look_along(context.frame, axis, side);
                        }});
    list.push_back({.id = "view.orthographic",
                    .title = "Orthographic",
                    .menu = "View/Point of view",
                    .help = "Draws without perspective: far things are as large as near ones.",
                    .shortcuts = {{.key = key::keypad_5, .scope = Scope::viewport}},
                    .separator = true,
                    .checked = [](const CommandContext& context) { return context.frame.view.camera.orthographic; },
                    .run = [](CommandContext& context) { context.viewport.toggle_orthographic(context.frame); }});
    list.push_back(
        {.id = "view.through_camera",
         .title = "Look through the camera",
         .menu = "View/Point of view",
         .help = "Shows what the camera node sees that is wired to the output.",
         .icon = icon::camera,
         .shortcuts = {{.key = key::keypad_0, .scope = Scope::viewport}},
         .enabled = has_camera,
         .checked =
             [](const CommandContext& context) { return has_camera(context) && context.frame.view.through_camera; },
         .run = [](CommandContext& context) { context.viewport.look_through_camera(context.frame); }});
    list.push_back({.id = "view.set_camera",
                    .title = "Set the camera from the view",
                    .menu = "View/Point of view",
                    .help = "Moves the camera node to where the viewport's eye is.",
                    .shortcuts = {{.key = key::keypad_0, .control = true, .alt = true, .scope = Scope::viewport}},
                    .enabled = has_camera,
                    .run = [](CommandContext& context) { context.viewport.set_camera_from_view(context.frame); }});
}

// One checked entry for each choice; the chosen one is kept in a member of the view state.
template <typename Kind>
void append_choices(std::vector<Command>& list, const std::vector<Kind>& choices, const std::string& verb,
                    const std::string& id, const std::string& menu, std::string ViewState::*member)
{
    for (const Choice& choice : choices)
        list.push_back(
            {.id = id + choice.name,
             .title = verb.empty() ? choice.title : verb + " " + graph::inside_a_sentence(choice.title),
             .menu = menu,
             .help = choice.help,
             .checked = [=](const CommandContext& context) { return context.frame.view.*member == choice.name; },
             .run = [=](CommandContext& context) { context.frame.view.*member = choice.name; }});
}

Command eye_switch(const char* id, const char* title, const char* help, bool StereoView::*member)
{
    return {
        .id = id,
        .title = title,
        .menu = "View/Stereo",
        .help = help,
        .checked = [member](const CommandContext& context) { return context.frame.view.eyes.*member; },
        .run = [member](
                   CommandContext& context) { context.frame.view.eyes.*member = !(context.frame.view.eyes.*member); }};
}

// A click on the picture does something else until it was done, or until Escape.
Command click_mode(const char* id, const char* title, const char* menu, const char* help, const char* icon, Click click)
{
    return {.id = id,
            .title = title,
            .menu = menu,
            .help = help,
            .icon = icon,
            .checked = [click](const CommandContext& context) { return context.frame.view.click == click; },
            .run =
                [click](CommandContext& context) {
                    Click& held = context.frame.view.click;
                    held = held == click ? Click::select : click;
                }};
}

void append_stereo(std::vector<Command>& list, const Readings& readings)
{
    append_choices(list, readings.stereo_modes, "", "view.stereo.", "View/Stereo", &ViewState::stereo);
    list.push_back(click_mode("stereo.converge", "Converge on what is clicked", "View/Stereo",
                              "The next click on the picture puts what is there into the plane of the screen.",
                              icon::crosshair, Click::converge));
    list.back().separator = true;
    list.push_back(
        {.id = "stereo.automatic",
         .title = "Set eyes for comfort",
         .menu = "View/Stereo",
         .help = "Sets the eyes' distance and convergence by the nearest and farthest things in the picture.",
         .run = [](CommandContext& context) { set_comfortable_eyes(context.frame); }});
    list.push_back(
        eye_switch("stereo.swap", "Swap eyes", "Gives each eye the other one's picture.", &StereoView::swap));
    list.push_back(eye_switch("stereo.split", "Compare with the plain anaglyph",
                              "Shows the plain anaglyph left of a divider that can be dragged.", &StereoView::split));
    list.push_back(eye_switch("stereo.rivalry", "Mark colours that fight",
                              "Draws stripes over colours that are bright for one eye and dark for the other.",
                              &StereoView::rivalry));
}

void append_field(std::vector<Command>& list, const Readings& readings)
{
    list.push_back(click_mode("field.inspect_ray", "Inspect a ray", "View/Field",
                              "A click on the picture lists every step of the ray that goes there.", icon::search,
                              Click::inspect));
    for (const Choice& style : readings.slice_styles)
        list.push_back({.id = "field.slice." + style.name,
                        .title = "Slice: " + graph::inside_a_sentence(style.title),
                        .menu = "View/Field",
                        .help = style.help,
                        .separator = &style == &readings.slice_styles.front(),
                        .checked =
                            [=](const CommandContext& context) {
                                const ViewState& view = context.frame.view;
                                return view.view == "slice" && view.slice.style == style.name;
                            },
                        .run =
                            [=](CommandContext& context) {
                                context.frame.view.view = "slice";
                                context.frame.view.slice.style = style.name;
                            }});
    list.push_back(
        {.id = "field.measure_nodes",
         .title = "Measure nodes",
         .menu = "View/Field",
         .help = "Finds out how long each node takes to draw, by drawing the picture without it.",
         .icon = icon::gauge,
         .separator = true,
         .enabled = [](const CommandContext& context) { return !context.frame.readings.node_costs.measuring; },
         .run = [](CommandContext& context) { context.frame.requests.push_back(MeasureNodes{}); }});
}

struct PanelName {
    Panel panel;
    const char *id, *title, *help;
};
constexpr PanelName panel_names[] = {
    {Panel::materials, "materials", "Materials", "Lists the materials of the scene."},
    {Panel::lights, "lights", "Lights", "Lists the lights of the scene."},
    {Panel::camera, "camera", "Camera and sky", "Shows the cameras and the sky of the scene."},
    {Panel::cost, "cost", "Cost", "Shows what the scene costs to draw."},
    {Panel::field, "field", "Field", "Shows the distance slice and the steps of a ray."},
    {Panel::stereo, "stereo", "Stereo", "Shows the distance of the eyes and where they converge."},
    {Panel::shader, "shader", "Shader", "Shows the shader that is written as you edit."},
    {Panel::problems, "problems", "Problems", "Lists what is wrong, with a jump to the node."},
    {Panel::history, "history", "History", "Lists the steps that can be undone."},
};

void append_panels(std::vector<Command>& list)
{
    for (const PanelName& panel : panel_names)
        list.push_back({.id = std::string("panel.") + panel.id,
                        .title = panel.title,
                        .menu = "View/Go to panel",
                        .help = panel.help,
                        .checked =
                            [which = panel.panel](const CommandContext& context) {
                                return context.frame.view.panes.shown && context.frame.view.panel == which;
                            },
                        .run =
                            [which = panel.panel](CommandContext& context) {
                                context.frame.view.panes.shown = true;
                                context.frame.view.panel = which;
                            }});
}

void append_workspaces(std::vector<Command>& list)
{
    for (const Workspace& workspace : workspaces())
        list.push_back({.id = std::string("workspace.") + workspace.id,
                        .title = workspace.title,
                        .menu = "View/Workspace",
                        .help = workspace.help,
                        .checked = [=](const CommandContext& context) { return workspace.holds(context.frame.view); },
                        .run = [=](CommandContext& context) { workspace.arrange(context.frame.view); }});
}

// A switch kept in the view state.
Command toggle(const char* id, const char* title, const char* help, bool ViewState::*member)
{
    return {.id = id,
            .title = title,
            .menu = "View",
            .help = help,
            .checked = [member](const CommandContext& context) { return context.frame.view.*member; },
            .run = [member](CommandContext& context) { context.frame.view.*member = !(context.frame.view.*member); }};
}

}  // namespace

void append_view_commands(std::vector<Command>& list, const Readings& readings)
{
    list.push_back(
        {.id = "view.panels",
         .title = "Show panels",
         .menu = "View",
         .help = "Shows the canvas and the panels, or the picture alone.",
         .shortcuts = {{.key = key::space, .scope = Scope::viewport}},
         .checked = [](const CommandContext& context) { return context.frame.view.panes.shown; },
         .run = [](CommandContext& context) { context.frame.view.panes.shown = !context.frame.view.panes.shown; }});
    append_panels(list);
    append_workspaces(list);
    append_framing(list);
    append_eye(list);
    append_choices(list, readings.views, "Show", "view.show.", "View/Picture", &ViewState::view);
    append_choices(list, readings.colour_maps, "Colour map", "view.colour_map.", "View/Colour map",
                   &ViewState::colour_map);
    append_stereo(list, readings);
    append_field(list, readings);
    list.push_back(toggle("view.statistics", "Statistics", "Shows how long the picture took, in the viewport.",
                          &ViewState::statistics));
    list.back().separator = true;
    list.push_back({.id = "view.gizmo",
                    .title = "Move handles",
                    .menu = "View",
                    .help = "Shows arrows on the selected node's surface that move it.",
                    .checked = [](const CommandContext& context) { return context.frame.view.gizmo; },
                    .run = [](CommandContext& context) { context.viewport.toggle_gizmo(context.frame); }});
    list.push_back(toggle("view.node_costs", "Costs on nodes", "Shows how long each node takes to draw, once measured.",
                          &ViewState::node_costs));
    list.push_back(toggle("view.minimap", "Minimap", "Shows the whole graph small in a corner of the canvas.",
                          &ViewState::minimap));
    list.push_back(toggle("view.reduced_motion", "Reduced motion", "Changes views at once instead of gliding there.",
                          &ViewState::reduced_motion));
}

}  // namespace fieldwright::ui
