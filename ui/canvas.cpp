// A frame of the node canvas: where it is, what is pressed, what is asked, what is drawn.
#include "ui/canvas.h"

#include "ui/canvas_edits.h"

#include "graph/custom_nodes.h"
#include "graph/own_type_edits.h"

#include <imgui_internal.h>

namespace fieldwright::ui {

using graph::NodeId;

namespace {

constexpr float pin_reach_px = 10, wire_reach_px = 6;  // design px, at every zoom

glm::vec2 mouse_px() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

}  // namespace

void Canvas::draw(FrameContext& frame)
{
    glide_.advance(frame.view.canvas, ImGui::GetIO().DeltaTime, frame.view.reduced_motion);
    place(frame);
    hovered_ = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    bool over = surface();
    zoom(frame);
    follow_hand(frame);
    Hover hover;
    {
        CanvasLayout layout(frame.draft.document.root, frame.draft.library, frame.view.selection, hands_.drag());
        serve(frame, layout);
        minimap(frame, layout, over);
        bool on_minimap = minimap_.shown() && minimap_.box_px().contains(mouse_px());
        bool looking = (over && !on_minimap) || !hands_.resting();
        float reach = frame.theme.px(pin_reach_px) / space_.scale;
        if (detail_at(frame.view.canvas.zoom) == Detail::boxes) reach = 0;  // no pins are drawn
        if (looking) hover = layout.at(space_.canvas(mouse_px()), reach, frame.theme.px(wire_reach_px) / space_.scale);
        grant(frame, hands_.update(frame, {space_, layout, hover, mouse_px(), over && !on_minimap}));
    }
    place(frame);
    // The document may have changed under the layout.
    CanvasLayout layout(frame.draft.document.root, frame.draft.library, frame.view.selection, hands_.drag());
    paint(frame, layout, hover);
    if (frame.view.minimap && minimap_.shown())
        minimap_.paint(*ImGui::GetWindowDrawList(), layout, space_, frame.view.selection, mouse_px());
    if (over || busy()) tooltip(frame, layout, hover);
    mark(frame, layout);
    rename_field(frame, layout);
    if (layout.nodes().empty()) empty_state(frame);
    breadcrumbs(frame);
    node_menu(frame);
    wire_menu(frame);
    const graph::NodeType* picked = add_menu_.draw(frame);
    if (picked && picked->category == own_category)
        add_custom_at(frame, picked->name.substr(own_prefix.size()), add_menu_.place().position);
    else if (picked) add_and_show(frame, *picked, add_menu_.place());
}

glm::vec2 Canvas::cursor_on_canvas() const
{
    bool here = space_.pane_px().contains(mouse_px());
    return space_.canvas(here ? mouse_px() : space_.pane_px().centre());
}

void Canvas::select_all(FrameContext& frame)
{
    frame.view.selection.clear();
    for (const graph::Node& node : frame.draft.document.root.nodes) frame.view.selection.add(node.id);
}

void Canvas::begin_rename(NodeId node)
{
    rename_ = {node, {}, true};
    show(node);
}

NodeId Canvas::add(FrameContext& frame, std::string_view type_name)
{
    const graph::NodeType* type = frame.draft.library.type(type_name);
    if (!type) return {};
    add_menu_.remember(type->name);
    return add_and_show(frame, *type, {.position = cursor_on_canvas()});
}

NodeId Canvas::add_custom(FrameContext& frame, std::string_view template_name)
{
    return add_custom_at(frame, template_name, cursor_on_canvas());
}

NodeId Canvas::add_custom_at(FrameContext& frame, std::string_view template_name, glm::vec2 position)
{
    Draft& draft = frame.draft;
    graph::Placed placed =
        graph::add_custom_node(draft.document, draft.library, template_name, position, frame.view.selection.nodes());
    if (!draft.done("Add a custom node", placed.refusal)) return {};
    const graph::OwnType& type = *graph::find_own_type(draft.document, draft.document.root.find(placed.node)->type);
    frame.requests.push_back(TrustCode{type.text, type.name});
    frame.view.selection.only(placed.node);
    show(placed.node);
    return placed.node;
}

void Canvas::place(const FrameContext& frame)
{
    ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    space_.corner_px = {corner.x, corner.y};
    space_.size_px = {size.x, size.y};
    space_.pan_px = frame.view.canvas.pan_px;
    space_.scale = frame.view.canvas.zoom * frame.theme.scale;
}

// One button under everything: what lies on top of it (a field, the menus) takes the mouse first.
bool Canvas::surface()
{
    ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImRect pane(corner, {corner.x + size.x, corner.y + size.y});
    ImGuiID id = ImGui::GetID("surface");
    ImGui::ItemSize(pane);
    if (!ImGui::ItemAdd(pane, id)) return false;
    bool hovered = false, held = false;
    ImGui::ButtonBehavior(pane, id, &hovered, &held,
                          ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                              ImGuiButtonFlags_MouseButtonMiddle | ImGuiButtonFlags_AllowItemOverlap);
    ImGui::SetItemAllowOverlap();
    ImGui::SetCursorScreenPos(corner);
    return hovered;
}

void Canvas::zoom(FrameContext& frame)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (!hovered_ || (io.MouseWheel == 0 && io.MouseWheelH == 0)) return;
    glide_.stop();
    zoom_about(frame.view.canvas, mouse_px() - space_.corner_px, io.MouseWheel);
    frame.view.canvas.pan_px.x += io.MouseWheelH * frame.theme.px(48);
    place(frame);
}

// A drag that leaves the pane takes the view with it.
void Canvas::follow_hand(FrameContext& frame)
{
    if (!hands_.doing<MovingNodes>() && !hands_.doing<Wiring>() && !hands_.doing<BoxSelecting>() &&
        !hands_.doing<LassoSelecting>() && !hands_.doing<MovingWires>())
        return;
    if (!ImGui::IsMousePosValid()) return;
    Box pane = space_.pane_px();
    glm::vec2 outside = mouse_px() - glm::clamp(mouse_px(), pane.low, pane.high);
    float reach = frame.theme.px(60), speed = frame.theme.px(900) * ImGui::GetIO().DeltaTime;
    frame.view.canvas.pan_px -= speed * glm::clamp(outside / reach, glm::vec2(-1), glm::vec2(1));
    place(frame);
}

// What commands asked for since the last frame.
void Canvas::serve(FrameContext& frame, const CanvasLayout& layout)
{
    Wanted wanted = std::exchange(wanted_, {});
    // The group is shown from the next frame on.
    if (wanted.opens_group) wanted_.frame_opening = true;
    std::optional<Box> box;
    if (wanted.frame_selected) box = layout.bounds(frame.view.selection.nodes());
    if (!box && (wanted.frame_all || wanted.frame_selected)) box = layout.bounds();
    if (box) glide_.start(frame.view.canvas, view_of(*box, space_.size_px, frame.theme.scale));
    if (wanted.frame_opening) open_view(frame, layout);
    if (const CanvasNode* node = layout.find(wanted.shown)) bring_into_view(frame, node->box);
    if (wanted.add_menu) {
        bool here = space_.pane_px().contains(mouse_px());
        add_menu_.open(here ? mouse_px() : space_.pane_px().centre(), {.position = cursor_on_canvas()});
    }
}

void Canvas::open_view(FrameContext& frame, const CanvasLayout& layout)
{
    std::optional<Box> all = layout.bounds();
    if (!all) return;
    Opening opening{.graph = *all, .end = *all};
    for (const CanvasNode& node : layout.nodes()) {
        opening.nodes.push_back(node.box);
        if (node.type && node.type->category == "output") opening.end = node.box;
    }
    if (frame.view.minimap) opening.corner_px = Minimap::room_px(space_.size_px, frame.theme);
    glide_.stop();
    frame.view.canvas = opening_view(opening, space_.size_px, frame.theme.scale);
    place(frame);
}

void Canvas::grant(FrameContext& frame, const CanvasWish& wish)
{
    if (!hands_.resting()) glide_.stop();
    if (wish.add) add_menu_.open(mouse_px(), *wish.add);
    if (wish.rename) begin_rename(wish.rename);
    if (wish.enter) enter(frame, wish.enter);
    if (!wish.menu) return;
    menu_for_ = *wish.menu;
    ImGui::OpenPopup(menu_for_.kind == Hover::Kind::wire ? "wire_menu" : "node_menu");
    (void)frame;
}

void Canvas::bring_into_view(const FrameContext& frame, const Box& box)
{
    Box room = space_.pane_px().grown(-frame.theme.px(24)), now = space_.screen(box);
    if (frame.view.minimap && minimap_.shown()) room.high.y = minimap_.box_px().low.y;
    if (room.contains(now.low) && room.contains(now.high)) return;
    CanvasView to = frame.view.canvas;
    to.pan_px += room.centre() - now.centre();
    glide_.start(frame.view.canvas, to);
}

void Canvas::minimap(FrameContext& frame, const CanvasLayout& layout, bool over)
{
    minimap_.place(layout, space_, frame.theme);
    if (!frame.view.minimap || !minimap_.shown()) return;
    bool pressed = over && hands_.resting() && ImGui::IsMouseClicked(0) && minimap_.box_px().contains(mouse_px());
    if (pressed) hands_.recentre();
    if (!hands_.doing<Recentring>()) return;
    glide_.stop();
    // Beyond the nodes the map would grow with every frame, and the view run away.
    std::optional<Box> nodes = layout.bounds();
    if (!nodes) return;
    glm::vec2 wanted = glm::clamp(minimap_.canvas(mouse_px()), nodes->low, nodes->high);
    frame.view.canvas.pan_px = 0.5f * space_.size_px - space_.scale * wanted;
}

NodeId Canvas::add_and_show(FrameContext& frame, const graph::NodeType& type, const AddPlace& place)
{
    NodeId node = add_at(frame, type, place);
    if (node) show(node);
    return node;
}

}  // namespace fieldwright::ui
