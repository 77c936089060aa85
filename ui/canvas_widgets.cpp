// What lies on the canvas as widgets: the field that renames a node, and menus.
#include "ui/canvas.h"

#include "ui/canvas_edits.h"
#include "ui/context_menu.h"
#include "ui/keys.h"
#include "ui/node_words.h"

#include "graph/fragment.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace fieldwright::ui {

using graph::NodeId;

namespace {

constexpr std::size_t name_limit = 256;        // bytes
constexpr glm::vec2 duplicate_offset{30, 30};  // canvas px

void remove_selected(FrameContext& frame)
{
    graph::Document trial = frame.draft.document;
    graph::Refusal refused;
    for (NodeId id : frame.view.selection.nodes())
        if (!refused) refused = graph::remove_node(trial, id);
    if (frame.draft.done("Delete", refused)) frame.draft.document = std::move(trial);
}

void duplicate_selected(FrameContext& frame)
{
    graph::Pasted copies = graph::duplicate_nodes(frame.draft.document, frame.draft.library,
                                                  frame.view.selection.as_set(), duplicate_offset);
    if (frame.draft.done("Duplicate", copies.refusal)) frame.view.selection.replace(copies.nodes);
}

}  // namespace

void Canvas::rename_field(FrameContext& frame, const CanvasLayout& layout)
{
    const CanvasNode* node = layout.find(rename_.node);
    if (!node) {
        rename_ = {};
        return;
    }
    if (!node->node->unknown_source.empty()) {
        frame.draft.done("Rename", graph::rename_node(frame.draft.document, rename_.node, ""));  // says why not
        rename_ = {};
        return;
    }
    if (rename_.opening) rename_.text = node->node->name;
    Box box = space_.screen(node->box);
    float size = std::max(13 * space_.scale, frame.theme.px(12)),
          height = std::max(node_header * space_.scale, 1.6f * size);
    SizedFont sized = canvas_font(frame.theme, size, true);
    float before = std::exchange(sized.font->Scale, sized.scale);
    ImGui::PushFont(sized.font);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.5f * size, 0.5f * (height - size)});
    ImGui::SetCursorScreenPos({box.low.x, box.low.y});
    ImGui::SetNextItemWidth(std::max(box.size().x, frame.theme.px(140)));
    if (rename_.opening) frame.focus_next_text();
    std::string title = node->type ? node->type->title : node->node->type;
    ImGui::InputTextWithHint("##rename", title.c_str(), &rename_.text, ImGuiInputTextFlags_AutoSelectAll);
    frame.rects.mark("canvas/rename");
    bool done = ImGui::IsItemDeactivated(), given_up = ImGui::IsKeyPressed(key::escape, false);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    sized.font->Scale = before;
    rename_.opening = false;
    if (!done) return;
    if (rename_.text.size() > name_limit) rename_.text.resize(name_limit);
    std::string step = "Rename " + graph::title_inside(*node->node, frame.draft.library);
    if (!given_up && rename_.text != node->node->name)
        frame.draft.done(step, graph::rename_node(frame.draft.document, rename_.node, rename_.text));
    rename_ = {};
}

void Canvas::node_menu(FrameContext& frame)
{
    ContextMenu menu("node_menu", frame.theme);
    if (!menu.open) return;
    graph::Document& document = frame.draft.document;
    std::set<NodeId> chosen = frame.view.selection.as_set();
    if (menu_item(frame, "rename", "Rename", "edit.rename")) begin_rename(menu_for_.node);
    bool all_muted = std::all_of(chosen.begin(), chosen.end(), [&](NodeId id) {
        const graph::Node* one = document.root.find(id);
        return one && one->muted;
    });
    const char* mute = all_muted ? "Unmute" : "Mute";
    if (menu_item(frame, "mute", mute, "edit.mute")) frame.draft.done(mute, graph::toggle_muted(document, chosen));
    if (menu_item(frame, "duplicate", "Duplicate", "edit.duplicate")) duplicate_selected(frame);
    if (const graph::Node* node = document.root.find(menu_for_.node)) group_entries(frame, *node);
    ImGui::Separator();
    if (menu_item(frame, "frame", "Frame selected", "view.frame_selected_nodes")) frame_selected();
    ImGui::Separator();
    if (menu_item(frame, "dissolve", "Dissolve", "edit.dissolve"))
        frame.draft.done("Dissolve", graph::dissolve(document, frame.draft.library, chosen));
    if (menu_item(frame, "delete", "Delete", "edit.delete")) remove_selected(frame);
}

void Canvas::wire_menu(FrameContext& frame)
{
    ContextMenu menu("wire_menu", frame.theme);
    if (!menu.open) return;
    if (menu_item(frame, "insert", "Insert a node…", "")) {
        ImVec2 at = ImGui::GetWindowPos();
        AddPlace place{.position = space_.canvas({at.x, at.y})};
        place.on_wire = {menu_for_.node, menu_for_.socket};
        add_menu_.open({at.x, at.y}, place);
    }
    if (menu_item(frame, "cut", "Cut the wire", "")) cut_wires(frame, {{menu_for_.node, menu_for_.socket}});
}

}  // namespace fieldwright::ui
