// Picture files that become shapes: dropped on the window, or chosen for a node.
#include "app/workbench.h"

#include "app/picture_paths.h"

namespace fieldwright::app {

// A picture becomes a shape of the scene.
void Workbench::take_dropped(const std::filesystem::path& file)
{
    if (is_picture_name(file)) editor_.ask(ui::UsePicture{file.string(), {}});
    else editor_.ask(ui::OpenFile{file.string()});
}

// For a node, or for a new one that joins the output.
void Workbench::use_picture(const ui::UsePicture& request)
{
    graph::Document document = session_.document();
    const graph::Library& library = *session_.library();
    graph::NodeId id = request.node;
    if (!id) {
        graph::Placed placed =
            graph::add_from_menu(document, library, "image", editor_.canvas().cursor_on_canvas(), {});
        if (placed.refusal) return say(*placed.refusal, true);
        id = placed.node;
    }
    const graph::Node* node = document.root.find(id);
    const graph::NodeType* type = node ? library.type(node->type) : nullptr;
    const graph::Parameter* parameter = type ? graph::image_parameter(*type) : nullptr;
    if (!parameter) return;
    std::string path = stored_picture_path(request.path, session_.folder());
    if (graph::Refusal refusal = graph::set_parameter(document, library, id, parameter->name, path))
        return say("The picture is not used: its path " + *refusal, true);
    session_.document() = std::move(document);
    session_.settle(request.node ? "Choose picture" : "Add picture");
    if (!request.node) editor_.view.selection.only(id);
    lower_scene();
    touch();
}

void Workbench::lower_scene()
{
    const graph::Document& document = session_.document();
    scene_.update(document, session_.library(),
                  pictures_.images(graph::image_requests(document, *session_.library()), session_.folder()));
    readings_.foreign_code.clear();
    for (const graph::OwnType& type : review_.foreign(session_.document()))
        readings_.foreign_code.push_back({type.name, type.text});
}

}  // namespace fieldwright::app
