// Rows of what a group exposes, and the menu that exposes.
#include "ui/group_interface.h"

#include "ui/context_menu.h"
#include "ui/node_words.h"
#include "ui/widgets.h"

#include "graph/group_edits.h"

#include <imgui_stdlib.h>

namespace fieldwright::ui {

const graph::Exposed* exposed_as(const Draft& draft, graph::NodeId node, std::string_view socket)
{
    const graph::Group* group = graph::find_group(draft.document, draft.document.entered);
    if (!group) return nullptr;
    for (const graph::Exposed& exposed : group->exposed)
        if (exposed.node == node && exposed.socket == socket) return &exposed;
    return nullptr;
}

void expose_menu(FrameContext& frame, const std::string& path, graph::NodeId node, std::string_view socket,
                 ImVec2 row_low)
{
    std::string group = frame.draft.document.entered;
    if (group.empty()) return;
    ImVec2 row_high(ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), row_low.y + frame.theme.row());
    bool here = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(row_low, row_high);
    if (here && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("expose_menu");
    ContextMenu menu("expose_menu", frame.theme);
    if (!menu.open) return;
    if (const graph::Exposed* exposed = exposed_as(frame.draft, node, socket)) {
        std::string name = exposed->name;
        bool chosen = ImGui::MenuItem("Expose no more");
        frame.rects.mark(path + "/hide");
        if (chosen)
            frame.draft.done("Expose " + name + " no more",
                             graph::hide(frame.draft.document, frame.draft.library, group, name));
        return;
    }
    bool chosen = ImGui::MenuItem("Expose");
    frame.rects.mark(path + "/expose");
    tooltip(frame, "Every node of the group gets a parameter or input of its own for this.");
    if (chosen)
        frame.draft.done("Expose " + std::string(socket),
                         graph::expose(frame.draft.document, frame.draft.library, group, node, socket));
}

void GroupInterface::draw(FrameContext& frame)
{
    const graph::Document& document = frame.draft.document;
    const graph::Group* open = graph::find_group(document, document.entered);
    if (!open) return;
    section(frame, "Group");
    float width = begin_row(frame, "Name", "What the group is called in the add menu and on its nodes.");
    if (name_row(frame, "group/name", open->name, width))
        frame.draft.done("Rename group", graph::rename_group(frame.draft.document, document.entered, edited_));
    section(frame, "Exposed");
    graph::Group shown = {open->name, open->exposed, open->output, {}};  // rows may change it
    for (const graph::Exposed& exposed : shown.exposed) exposed_row(frame, shown, exposed);
    if (shown.exposed.empty())
        paragraph(
            "Nothing yet. Right-click a parameter of a node in here and choose Expose: then every node of the "
            "group has it.");
}

// A field for a name that is done when the cursor leaves it, in `edited_`; true then.
bool GroupInterface::name_row(FrameContext& frame, const std::string& path, const std::string& name, float width_px,
                              const std::string& hint)
{
    RowPadding padding(frame.theme);
    bool editing = edited_path_ == path;
    std::string text = editing ? edited_ : name;
    ImGui::SetNextItemWidth(width_px);
    ImGui::InputTextWithHint(("##" + path).c_str(), hint.c_str(), &text, ImGuiInputTextFlags_AutoSelectAll);
    frame.rects.mark(path);
    if (ImGui::IsItemActivated()) editing = true;
    if (editing) edited_path_ = path, edited_ = text;
    if (!ImGui::IsItemDeactivated()) return false;
    edited_path_.clear();
    return editing && edited_ != name;
}

// What is said of it outside; left empty it is what is said inside. A wire inside makes its value none of the outside's.
bool GroupInterface::help_row(FrameContext& frame, const std::string& path, const graph::Exposed& exposed,
                              const graph::NodeType* type)
{
    const graph::Parameter* parameter = type ? type->parameter(exposed.socket) : nullptr;
    std::string inside = parameter && !parameter->help.empty() ? parameter->help : "What it does";
    bool described = name_row(frame, path, exposed.help, row_field_width(frame), inside);
    const graph::Node* node = frame.draft.document.root.find(exposed.node);
    if (parameter && node && node->input(exposed.socket))
        paragraph("Wired in here: outside it has a socket, whose wire takes the place of this one, and no value.");
    return described;
}

void GroupInterface::exposed_row(FrameContext& frame, const graph::Group& group, const graph::Exposed& exposed)
{
    Draft& draft = frame.draft;
    std::string path = "group/exposed/" + exposed.name;
    const graph::Node* node = draft.document.root.find(exposed.node);
    const graph::NodeType* type = node ? draft.library.type(node->type) : nullptr;
    ImGui::PushID(path.c_str());
    float side = frame.theme.row(), room = ImGui::GetContentRegionAvail().x;
    float field = std::floor(std::max(0.5f * (room - 3 * side), frame.theme.px(60)));
    bool renamed = name_row(frame, path, exposed.name, field);
    ImGui::SameLine(0, frame.theme.gap());
    std::string drives = (node ? node_title(*node, type) : "") + ": " + socket_label(type, exposed.socket);
    line_text(frame, drives, colour::quiet_text, room - field - 3 * side - 4 * frame.theme.gap());
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3 * side);
    bool first = &exposed == &group.exposed.front(), last = &exposed == &group.exposed.back();
    ImGui::BeginDisabled(first);
    bool up = icon_button(frame, "up", icon::arrow_up, "Move up");
    ImGui::EndDisabled();
    frame.rects.mark(path + "/up");
    ImGui::SameLine(0, 0);
    ImGui::BeginDisabled(last);
    bool down = icon_button(frame, "down", icon::arrow_down, "Move down");
    ImGui::EndDisabled();
    frame.rects.mark(path + "/down");
    ImGui::SameLine(0, 0);
    bool removed = icon_button(frame, "remove", icon::close, "Expose it no more");
    frame.rects.mark(path + "/remove");
    bool described = help_row(frame, path + "/help", exposed, type);
    ImGui::PopID();
    if (described)
        draft.done("Describe " + exposed.name,
                   graph::describe_exposed(draft.document, group.name, exposed.name, edited_));
    else if (renamed)
        draft.done("Rename " + exposed.name, graph::rename_exposed(draft.document, group.name, exposed.name, edited_));
    else if (up || down)
        draft.done("Move " + exposed.name,
                   graph::move_exposed(draft.document, draft.library, group.name, exposed.name, up ? -1 : 1));
    else if (removed)
        draft.done("Expose " + exposed.name + " no more",
                   graph::hide(draft.document, draft.library, group.name, exposed.name));
}

}  // namespace fieldwright::ui
