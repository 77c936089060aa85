// Commands of the Add menu: the add menu itself, and one for each node type.
#include "ui/canvas.h"
#include "ui/commands.h"
#include "ui/keys.h"

#include "graph/custom_nodes.h"
#include "graph/light_rig.h"
#include "graph/words.h"

namespace fieldwright::ui {
namespace {

void add_outdoor_light(CommandContext& context)
{
    Draft& draft = context.frame.draft;
    graph::Placed placed = graph::add_outdoor_light(draft.document, draft.library, context.canvas.cursor_on_canvas());
    if (draft.done("Add outdoor light", placed.refusal)) context.frame.view.selection.only(placed.node);
}

}  // namespace

void append_add_commands(std::vector<Command>& list, const graph::Library& library)
{
    list.push_back({.id = "add.menu",
                    .title = "Add a node…",
                    .menu = "Add",
                    .help = "Opens the list of node types, to be searched by name.",
                    .icon = icon::add,
                    .shortcuts = {{.key = 'A', .shift = true, .scope = Scope::canvas},
                                  {.key = key::space, .scope = Scope::canvas},
                                  {.key = key::tab, .scope = Scope::viewport},
                                  {.key = 'A', .shift = true, .scope = Scope::viewport}},
                    .run = [](CommandContext& context) {
                        context.frame.view.panes.shown = true;
                        context.canvas.open_add_menu();
                    }});
    for (const graph::CustomTemplate& custom : graph::custom_templates())
        list.push_back({.id = "add.custom/" + std::string(custom.name),
                        .title = "Add " + graph::inside_a_sentence(std::string(custom.title)),
                        .menu = "Add/Custom",
                        .help = std::string(custom.help),
                        .icon = icon::code,
                        .separator = &custom == &graph::custom_templates().front(),
                        .run = [name = custom.name](CommandContext& context) {
                            context.frame.view.panes.shown = true;
                            context.canvas.add_custom(context.frame, name);
                        }});
    list.push_back({.id = "add.outdoor_light",
                    .title = "Add outdoor light",
                    .menu = "Add",
                    .help = "Lights the scene as outdoors: a sun with soft shadows, its sky, and darker corners.",
                    .icon = icon::sun,
                    .separator = true,
                    .run = add_outdoor_light});
    std::string category;
    for (const graph::NodeType* type : library.types()) {
        list.push_back(
            {.id = "add." + type->name,
             .title = "Add " + graph::inside_a_sentence(type->title),
             .menu = "Add/" + graph::category_title(type->category),
             .help = type->help,
             .separator = category.empty(),
             .run = [name = type->name](CommandContext& context) { context.canvas.add(context.frame, name); }});
        category = type->category;
    }
}

}  // namespace fieldwright::ui
