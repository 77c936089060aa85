// Lights: what lights the scene.
#include "ui/node_list.h"
#include "ui/panel_pages.h"
#include "ui/widgets.h"

#include "graph/compose.h"

#include <algorithm>

namespace fieldwright::ui {
namespace {

bool has_lights(const FrameContext& frame)
{
    const auto& nodes = frame.draft.document.root.nodes;
    return std::any_of(nodes.begin(), nodes.end(), [&](const graph::Node& node) {
        const graph::NodeType* type = frame.draft.library.type(node.type);
        return type && type->output == graph::SocketKind::light;
    });
}

// The first type of light that has no place: it shines everywhere, so it is what an unlit scene wants.
const graph::NodeType* first_offer(const graph::Library& library)
{
    const graph::NodeType* any = nullptr;
    for (const graph::NodeType* type : library.types()) {
        if (type->output != graph::SocketKind::light) continue;
        if (!type->parameter("position")) return type;
        any = type;
    }
    return any;
}

void offer(FrameContext& frame, const graph::NodeType& type)
{
    std::string label = std::string(icon::sun) + "  Add a " + graph::inside_a_sentence(type.title);
    float width = ImGui::CalcTextSize(label.c_str()).x + frame.theme.px(28);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5f * (ImGui::GetContentRegionAvail().x - width));
    bool pressed = text_button(frame, "offer", label, width);
    frame.rects.mark("panel/lights/offer");
    if (!pressed) return;
    graph::Placed placed = graph::add_alone(frame.draft.document, frame.draft.library, type.name, {0, 0});
    if (frame.draft.done("Add " + graph::inside_a_sentence(type.title), placed.refusal))
        frame.view.selection.only(placed.node);
}

}  // namespace

void draw_lights_panel(FrameContext& frame, NodeList& lights)
{
    bool empty = !has_lights(frame);
    lights.draw(frame, "Lights", "No lights: only the sky lights the scene, without shadows.");
    if (const graph::NodeType* type = empty ? first_offer(frame.draft.library) : nullptr) offer(frame, *type);
}

}  // namespace fieldwright::ui
