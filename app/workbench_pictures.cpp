// Picture files that become shapes: dropped on the window, or chosen for a node.
#include "app/workbench.h"

#include "app/picture_paths.h"
#include "graph/picture_scene.h"

namespace fieldwright::app {

// A picture becomes a shape of the scene, unless it keeps a scene of its own.
void Workbench::take_dropped(const std::filesystem::path& file)
{
    if (is_picture_name(file) && !graph::holds_scene(file)) editor_.ask(ui::UsePicture{file.string(), {}});
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

void Workbench::measure_nodes()
{
    const graph::Document& document = session_.document();
    node_costs_.measure({document, session_.library(),
                         pictures_.images(graph::image_requests(document, *session_.library()), session_.folder()),
                         wanted_picture().frame});
    touch();
}

void Workbench::inspect_ray(const ui::InspectRay& request)
{
    if (!requested_) return;
    glm::ivec2 size = picture_.size(), frame(requested_->frame.width, requested_->frame.height);
    glm::ivec2 pixel = glm::ivec2(request.x, request.y) * frame / glm::max(size, glm::ivec2(1));
    attempt([&] { ray_.choose(*scene_.program(), requested_->frame, pixel); });
    touch();
}

void Workbench::lower_scene()
{
    node_costs_.forget();
    const graph::Document& document = session_.document();
    scene_.update(document, session_.library(),
                  pictures_.images(graph::image_requests(document, *session_.library()), session_.folder()));
    readings_.foreign_code.clear();
    for (const graph::OwnType& type : review_.foreign(session_.document()))
        readings_.foreign_code.push_back({type.name, type.text});
}

}  // namespace fieldwright::app
