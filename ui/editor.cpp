// Layout of the window and the life of a gesture.
#include "ui/editor.h"

#include "ui/group_actions.h"
#include "ui/keys.h"

#include "graph/group_edits.h"
#include "graph/group_types.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr float splitter_px = 4;    // design px
constexpr ImU32 no_background = 0;  // what the window is cleared in shows: each layer costs software GL milliseconds
constexpr const char* canvas_hint =
    "Drag to select, right-drag to move the view, wheel to zoom; Space adds a node, F1 shows all shortcuts";
constexpr ImGuiWindowFlags pane_flags = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;

// A child window with a background of its own; `draw` fills it.
// True when the mouse is over it.
template <typename Draw>
bool pane(const char* name, ImVec2 position, ImVec2 size, ImU32 background, ImVec2 padding, ImGuiWindowFlags flags,
          const Draw& draw)
{
    if (size.x < 1 || size.y < 1) return false;
    ImGui::SetCursorScreenPos(position);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, background);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::BeginChild(name, size, false, flags | ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    draw();
    bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
    ImGui::EndChild();
    return hovered;
}

void begin_host_window(const Theme& theme)
{
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(window.Pos);
    ImGui::SetNextWindowSize(window.Size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, menu_bar_padding(theme));
    ImGui::Begin("window", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoBackground |
                     pane_flags);  // the window is cleared in its colour
    ImGui::PopStyleVar(3);
}

int open_popups() { return ImGui::GetCurrentContext()->OpenPopupStack.Size; }

// Escape closes the topmost menu, for those that did not see to it themselves in this frame. Questions know what it
// means to them; in a field of a menu it means the field.
void close_by_escape(int open_before, bool was_typing)
{
    const ImVector<ImGuiPopupData>& popups = ImGui::GetCurrentContext()->OpenPopupStack;
    if (!ImGui::IsKeyPressed(key::escape, false) || was_typing || !open_before || popups.Size != open_before) return;
    const ImGuiWindow* top = popups.back().Window;
    if (top && !(top->Flags & ImGuiWindowFlags_Modal)) ImGui::ClosePopupToLevel(popups.Size - 1, true);
}

}  // namespace

Editor::Output Editor::draw(graph::Document& document, const graph::Library& library, const Readings& readings,
                            const Theme& theme)
{
    follow_selection(document);
    Output output;
    {
        graph::Entered entered(document, shown_group(document, view));
        output = draw_shown(document, library, readings, theme);
    }
    // What was done inside a group may show outside.
    if (output.document_changed && !document.groups.empty()) graph::settle_groups(document, library);
    return output;
}

// A light or camera of the scene, chosen in its panel while a group is open: the scene is shown.
void Editor::follow_selection(const graph::Document& document)
{
    if (!view.way.empty() && document.root.find(view.selection.active())) close_groups(view);
}

Editor::Output Editor::draw_shown(graph::Document& document, const graph::Library& library, const Readings& readings,
                                  const Theme& theme)
{
    Output output;
    Draft draft{.document = document, .library = library};
    rects.begin_frame();
    view.selection.keep_existing(document.root);
    view.hint.clear();
    FrameContext frame{draft, view, readings, output.requests, theme, rects};
    CommandContext context{frame, canvas_, viewport_, palette_, sheet_, dialogs_};
    commands_ = commands(readings, library);
    int popups = open_popups();
    bool was_typing = ImGui::GetIO().WantTextInput;

    begin_host_window(theme);
    run_commands(context);
    if (auto node = std::exchange(view.frame_request, {})) canvas_.show(node);
    if (std::exchange(view.add_request, false)) run_command("add.menu", context);
    // A command may have made a group.
    std::shared_ptr<const graph::Library> fresh;
    if (!draft.step.empty() && !document.groups.empty()) fresh = graph::library_of(document, library);
    Draft rest{document, fresh ? *fresh : library, draft.step, draft.step_ends, draft.refusal};
    FrameContext after{rest, view, readings, output.requests, theme, rects, frame.text_expected};
    CommandContext commands_after{after, canvas_, viewport_, palette_, sheet_, dialogs_};
    draw_panes(after);
    draw_dialogs(commands_after);
    close_by_escape(popups, was_typing);
    double now_s = ImGui::GetTime();
    if (!rest.refusal.empty()) status_line_.refuse(rest.refusal, now_s);
    status_line_.draw(after, now_s);
    ImGui::End();

    draft.step = rest.step;
    draft.step_ends = rest.step_ends;
    output.text_expected = after.text_expected;
    output.document_changed = !draft.step.empty();
    if (output.document_changed) pending_step_ = draft.step;
    output.hands_moving = !hands_free();
    // From a text field straight to another widget: the first gesture has ended though hands go on moving.
    ImGuiID before = std::exchange(active_item_, ImGui::GetActiveID());
    bool handed_over = before && before != active_item_ && draft.step.empty();
    if (!output.hands_moving || handed_over || draft.step_ends) output.settled_step = std::exchange(pending_step_, {});
    if (auto at_s = status_line_.changes_at_s()) output.redraw_in_s = std::max(*at_s - now_s, 0.0);
    return output;
}

bool Editor::hands_free() const { return !ImGui::IsAnyItemActive() && !canvas_.busy() && !viewport_.busy(); }

// Those asked for by the program, from the menus and by keys; before the panes, so that they show the outcome.
void Editor::run_commands(CommandContext& context)
{
    for (const std::string& id : std::exchange(asked_commands_, {})) run_command(id, context);
    run_command(menu_bar_.draw(context, commands_), context);
    run_pressed_shortcut(context);
}

void Editor::run_command(std::string_view id, CommandContext& context)
{
    const Command* command = find_command(commands_, id);
    if (command && command->is_enabled(context)) command->run(context);
}

void Editor::run_pressed_shortcut(CommandContext& context)
{
    bool popup_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (ImGui::GetIO().WantTextInput || popup_open || !hands_free()) return;
    if (const Command* command = pressed_command(commands_, over_)) run_command(command->id, context);
}

void Editor::browse(ChooseFile what, std::string folder, std::string name)
{
    browser_.open(std::move(what), folder, std::move(name));
}

void Editor::draw_dialogs(CommandContext& context)
{
    FrameContext& frame = context.frame;
    run_command(palette_.draw(context, commands_), context);
    sheet_.draw(frame, commands_);
    for (Request& request : std::exchange(asked_, {})) frame.requests.push_back(std::move(request));
    dialogs_.hold_back(frame.requests, frame.readings, browser_.is_open());
    // What they ask for has been asked about.
    dialogs_.draw(frame);
    browser_.draw(frame, !dialogs_.asking());
}

void Editor::draw_panes(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    Panes& panes = view.panes;
    ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    float top = low.y + theme.menu_bar(), bottom = low.y + size.y - theme.status_line();
    float side = panes.shown ? std::clamp(theme.px(panes.side_width), theme.px(280),
                                          std::max(size.x - theme.px(320), theme.px(280)))
                             : 0;
    float height = bottom - top, left_width = size.x - side, bar = panes.shown ? theme.px(splitter_px) : 0;
    float viewport_height = panes.shown ? std::floor(height * (1 - panes.canvas_share)) : height;
    float inspector_height = std::floor(height * panes.inspector_share);

    over_ = Scope::everywhere;
    bool over_viewport = pane("viewport", {low.x, top}, {left_width - bar, viewport_height - bar}, no_background,
                              {0, 0}, pane_flags, [&] {
                                  ImVec2 room = ImGui::GetWindowSize();
                                  viewport_size_px_ = {static_cast<int>(room.x), static_cast<int>(room.y)};
                                  viewport_.draw(frame);
                              });
    if (over_viewport) over_ = Scope::viewport;
    if (!panes.shown) return;
    bool over_canvas = pane("canvas", {low.x, top + viewport_height}, {left_width - bar, height - viewport_height},
                            colour::canvas, {0, 0}, pane_flags, [&] { canvas_.draw(frame); });
    if (over_canvas) over_ = Scope::canvas;
    if (over_canvas && view.hint.empty()) view.hint = canvas_hint;
    ImVec2 inset{theme.padding(), theme.padding()};
    pane("inspector", {low.x + left_width, top}, {side, inspector_height - bar}, colour::panel, inset, 0,
         [&] { inspector_.draw(frame); });
    pane("panels", {low.x + left_width, top + inspector_height}, {side, height - inspector_height}, colour::panel,
         inset, 0, [&] { panels_.draw(frame); });

    float side_share = side / size.x;
    ImGui::SetCursorScreenPos({low.x + left_width - bar, top});
    splitter("side", false, side_share, theme.px(280), size.x - theme.px(320), size.x, frame);
    panes.side_width = side_share * size.x / theme.scale;
    ImGui::SetCursorScreenPos({low.x, top + viewport_height - bar});
    splitter("canvas", true, panes.canvas_share, 0.1f * height, 0.9f * height, height, frame);
    float inspector_rest = 1 - panes.inspector_share;
    ImGui::SetCursorScreenPos({low.x + left_width, top + inspector_height - bar});
    splitter("inspector", true, inspector_rest, 0.15f * height, 0.85f * height, height, frame);
    panes.inspector_share = 1 - inspector_rest;
}

// A bar that moves the border between two panes; `share` is that of the pane after it.
void Editor::splitter(const char* name, bool vertical, float& share, float low, float high, float length_px,
                      FrameContext& frame)
{
    ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetWindowSize(), corner = ImGui::GetWindowPos();
    float thickness = frame.theme.px(splitter_px);
    bool right_column = vertical && std::string_view(name) == "inspector";
    float side = frame.theme.px(view.panes.side_width);
    ImVec2 size = vertical ? ImVec2(right_column ? side : room.x - side, thickness)
                           : ImVec2(thickness, corner.y + room.y - frame.theme.status_line() - at.y);
    ImRect bar(at, {at.x + size.x, at.y + size.y});
    if (high < low) return;  // a window too small to divide
    // Dear ImGui asserts that neither side gets below its least, which holds for whole numbers only.
    low = std::ceil(low), high = std::floor(high), length_px = std::round(length_px);
    float before_least = length_px - high;
    float after = std::round(std::clamp(share * length_px, low, high)), before = length_px - after;
    ImGui::PushStyleColor(ImGuiCol_Separator, ImVec4(0, 0, 0, 0));
    ImGui::PushID(name);
    if (ImGui::SplitterBehavior(bar, ImGui::GetID("splitter"), vertical ? ImGuiAxis_Y : ImGuiAxis_X, &before, &after,
                                before_least, low, frame.theme.px(3)))
        share = std::clamp(after, low, high) / length_px;
    frame.rects.mark(std::string("splitter/") + name, {{bar.Min.x, bar.Min.y}, {bar.Max.x, bar.Max.y}});
    ImGui::PopID();
    ImGui::PopStyleColor();
}

}  // namespace fieldwright::ui
