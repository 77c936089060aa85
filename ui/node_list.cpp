// Drawing a list of nodes and doing what its buttons say.
#include "ui/node_list.h"

#include "graph/fragment.h"
#include "graph/neighbours.h"
#include "graph/scene_parts.h"
#include "ui/colour_field.h"
#include "ui/lamp_place.h"
#include "ui/parameter_rows.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

// The first colour of a node stands for it, unless a wire drives it.
std::optional<glm::vec3> colour_of(const graph::Node& node, const graph::NodeType& type)
{
    for (const graph::Parameter& parameter : type.parameters) {
        if (parameter.kind != graph::ParameterKind::colour) continue;
        if (node.input(parameter.name)) break;
        const graph::Value* value = node.parameter(parameter.name);
        const auto* linear = value ? std::get_if<glm::vec3>(value) : nullptr;
        if (linear) return *linear;
    }
    return std::nullopt;
}

// Materials, lights, cameras and skies are named alike as kinds and as categories.
const char* kind_icon(graph::SocketKind kind) { return category_icon(graph::socket_kind_name(kind)); }

bool is_free(const graph::Graph& graph, glm::vec2 place)
{
    return std::none_of(graph.nodes.begin(), graph.nodes.end(), [&](const graph::Node& node) {
        glm::vec2 apart = glm::abs(node.position - place);
        return apart.x < 180 && apart.y < 110;
    });
}

// On the canvas: below the last of its kind, or left below the output.
glm::vec2 place_for(const graph::Document& document, const graph::Library& library, graph::SocketKind kind)
{
    glm::vec2 place{0, 0};
    if (const graph::Node* output = graph::shown_output(document, library))
        place = output->position + glm::vec2(-graph::column_px, 120);
    for (const graph::Node& node : document.root.nodes)
        if (const graph::NodeType* type = library.type(node.type); type && type->output == kind)
            place = node.position + glm::vec2(0, 120);
    for (int tries = 0; tries < 200 && !is_free(document.root, place); ++tries) place.y += 120;
    return place;
}

bool is_field(const graph::Document& document, const graph::Library& library, graph::NodeId id)
{
    const graph::Node* node = document.root.find(id);
    const graph::NodeType* type = node ? library.type(node->type) : nullptr;
    return type && type->is_field() && !graph::is_output(*type);
}

}  // namespace

std::string NodeList::mark(graph::NodeId id, std::string_view part) const
{
    std::string name = path_ + "/" + std::to_string(id.number);
    return part.empty() ? name : name + "/" + std::string(part);
}

void NodeList::draw(FrameContext& frame, std::string_view heading, std::string_view when_empty)
{
    ImGui::PushID(path_.c_str());
    heading_row(frame, heading);
    std::vector<graph::NodeId> ids;
    for (const graph::Node& node : frame.draft.document.root.nodes)
        if (lists(frame.draft.library.type(node.type))) ids.push_back(node.id);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.theme.padding(), 0));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(ids.size()), frame.theme.row());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            // An earlier row's button may just have deleted it.
            if (frame.draft.document.root.find(ids[static_cast<std::size_t>(i)]))
                row(frame, ids[static_cast<std::size_t>(i)]);
    ImGui::PopStyleVar();
    if (ids.empty()) {
        ImGui::PushFont(frame.theme.fonts.text);
        empty_state(frame, kind_icon(kind_), when_empty);
        offer(frame);
        ImGui::PopFont();
    }
    graph::NodeId active = frame.view.selection.active();
    if (std::find(ids.begin(), ids.end(), active) != ids.end())
        if (const graph::Node* node = frame.draft.document.root.find(active)) {
            section(frame, title_of(*node, frame.draft.library));
            parameter_rows(frame, path_, active);
        }
    ImGui::PopID();
}

void NodeList::heading_row(FrameContext& frame, std::string_view heading)
{
    std::string label = std::string(icon::add) + "  Add " + noun_;
    float width = ImGui::CalcTextSize(label.c_str()).x + frame.theme.px(20);
    ImGui::PushFont(frame.theme.fonts.heading);
    line_text(frame, heading, colour::text,
              std::max(ImGui::GetContentRegionAvail().x - width - frame.theme.padding(), 1.0f));
    ImGui::PopFont();
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    if (text_button(frame, "add", label, width)) ImGui::OpenPopup("add menu");
    frame.rects.mark(path_ + "/add");
    ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, corner.y + frame.theme.gap()}, ImGuiCond_Always, {1, 0});
    if (ImGui::BeginPopup("add menu")) {
        add_menu(frame);
        ImGui::EndPopup();
    }
}

// An empty list of materials offers one for the shape at hand.
void NodeList::offer(FrameContext& frame)
{
    graph::NodeId active = frame.view.selection.active();
    if (kind_ != graph::SocketKind::material || !is_field(frame.draft.document, frame.draft.library, active)) return;
    std::string label = std::string(icon::add) + "  Add a material to " +
                        graph::title_inside(*frame.draft.document.root.find(active), frame.draft.library);
    float room = ImGui::GetContentRegionAvail().x;
    float width = std::min(ImGui::CalcTextSize(label.c_str()).x + frame.theme.px(28), room);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::floor(0.5f * (room - width)));
    if (text_button(frame, "offer", label, width)) ImGui::OpenPopup("add menu");
    frame.rects.mark(path_ + "/offer");
}

void NodeList::add_menu(FrameContext& frame)
{
    for (const graph::NodeType* type : frame.draft.library.types()) {
        if (!lists(type)) continue;
        bool chosen = ImGui::Selectable(type->title.c_str(), false, 0, {frame.theme.px(140), frame.theme.px(20)});
        frame.rects.mark(path_ + "/add/" + type->name);
        tooltip(frame, type->help);
        if (chosen) add(frame, *type);
    }
}

void NodeList::add(FrameContext& frame, const graph::NodeType& type)
{
    graph::Document& document = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    glm::vec2 place = place_for(document, library, kind_);
    graph::NodeId active = frame.view.selection.active();
    std::string step = "Add " + graph::inside_a_sentence(type.title);
    graph::Placed placed;
    if (!output_socket.empty()) {
        placed = graph::add_to_output(document, library, type.name, place);
    } else if (type.output == graph::SocketKind::material && is_field(document, library, active)) {
        step += " to " + graph::title_inside(*document.root.find(active), library);
        placed = graph::add_material(document, library, type.name, active);
    } else {
        placed = graph::add_alone(document, library, type.name, place);
        place_lamp(frame, document, placed.node);
    }
    if (frame.draft.done(step, placed.refusal)) frame.view.selection.only(placed.node);
}

void NodeList::row(FrameContext& frame, graph::NodeId id)
{
    const graph::Node& node = *frame.draft.document.root.find(id);
    const graph::NodeType& type = *frame.draft.library.type(node.type);
    const Theme& theme = frame.theme;
    ImGui::PushID(static_cast<int>(id.number));
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImVec2 high(low.x + ImGui::GetContentRegionAvail().x, low.y + theme.row());
    bool selected = frame.view.selection.contains(id),
         hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (selected || hovered)
        draw.AddRectFilled(low, high, selected ? colour::rgb(0x2c3540) : colour::rgb(0x23282f), theme.px(4));
    if (selected) draw.AddRectFilled(low, {low.x + theme.px(2), high.y}, colour::accent, theme.px(1));
    ImVec2 mark_low(low.x + theme.px(8), low.y + theme.px(4));
    if (std::optional<glm::vec3> linear = colour_of(node, type))
        draw_swatch(frame, *linear, mark_low, {theme.px(16), theme.px(16)});
    else
        draw.AddText({mark_low.x, low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()))}, colour::quiet_text,
                     category_icon(type.category));
    float icons = theme.row() * static_cast<float>(2 + (mutes ? 1 : 0) + (output_socket.empty() ? 0 : 1));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + theme.px(30));
    name(frame, node, ImGui::GetContentRegionAvail().x - icons);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - icons);
    row_icons(frame, id, selected || hovered);
    ImGui::PopID();
}

void NodeList::name(FrameContext& frame, const graph::Node& node, float width_px)
{
    const Theme& theme = frame.theme;
    if (renaming_ == node.id) {
        if (std::exchange(focus_name_, false)) frame.focus_next_text();
        node_name_field(frame, mark(node.id, "name"), node, width_px);
        if (ImGui::IsItemDeactivated()) renaming_ = {};
        return;
    }
    std::string title = title_of(node, frame.draft.library), shown = fitted(title, width_px - theme.px(4));
    ImVec2 low = ImGui::GetCursorScreenPos();
    bool pressed = ImGui::InvisibleButton("name", {std::max(width_px, 1.0f), theme.row()});
    frame.rects.mark(mark(node.id));
    ImGui::GetWindowDrawList()->AddText({low.x, low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()))},
                                        node.muted ? colour::quiet_text : colour::text, shown.c_str());
    tooltip(frame, (shown == title ? "" : title + "\n") + "Double-click to rename");
    if (pressed) frame.view.selection.only(node.id);
    if (!ImGui::IsItemHovered() || !ImGui::IsMouseDoubleClicked(0)) return;
    renaming_ = node.id;
    focus_name_ = true;
}

void NodeList::row_icons(FrameContext& frame, graph::NodeId id, bool shown)
{
    float width = frame.theme.row();
    bool copied = false, removed = false;
    if (shown) {
        copied = icon_button(frame, "duplicate", icon::copy, "Duplicate");
        frame.rects.mark(mark(id, "duplicate"));
        ImGui::SameLine(0, 0);
        removed = icon_button(frame, "delete", icon::trash, "Delete");
        frame.rects.mark(mark(id, "delete"));
    } else {
        ImGui::Dummy({2 * width, width});
    }
    if (mutes) {
        ImGui::SameLine(0, 0);
        mute_button(frame, mark(id, "mute"), *frame.draft.document.root.find(id));
    }
    if (!output_socket.empty()) {
        ImGui::SameLine(0, 0);
        use_icon(frame, id);
    }
    if (copied) duplicate(frame, id);
    if (removed) remove(frame, id);
}

void NodeList::use_icon(FrameContext& frame, graph::NodeId id)
{
    graph::Document& document = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    const graph::Node* output = graph::shown_output(document, library);
    bool used = output && output->input(output_socket) == id;
    bool pressed = icon_button(frame, "use", used ? icon::dot_on : icon::dot_off,
                               used ? "The output uses this " + noun_ : "Use this " + noun_ + " for the output",
                               used ? colour::text : colour::quiet_text);
    frame.rects.mark(mark(id, "use"));
    if (!pressed || used) return;
    if (!output) {
        frame.draft.refusal = "The scene has no output yet; add one to use a " + noun_;
        return;
    }
    std::string step = "Use " + graph::title_inside(*document.root.find(id), library);
    frame.draft.done(step, graph::connect(document, library, id, output->id, output_socket));
}

void NodeList::duplicate(FrameContext& frame, graph::NodeId id)
{
    graph::Document& document = frame.draft.document;
    const graph::Library& library = frame.draft.library;
    const graph::Node& node = *document.root.find(id);
    glm::vec2 offset = place_for(document, library, kind_) - node.position;
    std::string step = "Duplicate " + graph::title_inside(node, library);
    graph::Pasted pasted = graph::duplicate_nodes(document, library, {id}, offset, graph::Incoming::keep);
    if (frame.draft.done(step, pasted.refusal) && !pasted.nodes.empty())
        frame.view.selection.only(pasted.nodes.front());
}

void NodeList::remove(FrameContext& frame, graph::NodeId id)
{
    std::string step = "Delete " + graph::title_inside(*frame.draft.document.root.find(id), frame.draft.library);
    if (frame.draft.done(step, graph::remove_node(frame.draft.document, id))) frame.view.selection.remove(id);
}

}  // namespace fieldwright::ui
