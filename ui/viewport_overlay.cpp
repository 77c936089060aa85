// Drawing what lies over the picture.
#include "ui/viewport_overlay.h"

#include "ui/commands.h"
#include "ui/legend.h"
#include "ui/number_text.h"
#include "ui/viewport.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fieldwright::ui {
namespace {

constexpr float inset_px = 8;            // of everything from the pane's edges, design px
constexpr float legend_beside_px = 760;  // narrower panes have the legend above the statistics
constexpr float roomy_px = 460;          // the toolbar's buttons lose their words below this width

// Buttons that let the picture through.
class ToolbarStyle {
public:
    explicit ToolbarStyle(const Theme& theme)
    {
        ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, theme.px(6));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(4), theme.px(4)});
        float above = std::floor(0.5f * (theme.row() - ImGui::GetFontSize()));
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme.px(8), above});
        ImGui::PushStyleColor(ImGuiCol_Button, colour::veil);
        ImGui::PushStyleColor(ImGuiCol_FrameBg, colour::veil);
    }
    ~ToolbarStyle()
    {
        ImGui::PopStyleColor(2);
        ImGui::PopStyleVar(3);
    }
};

void tooltip(std::string text, std::string_view command_id)
{
    if (mouse_rests()) ImGui::SetTooltip("%s", with_shortcut(std::move(text), command_id).c_str());
}

// A button that is on or off.
bool toggle(FrameContext& frame, const char* icon, bool on, std::string_view name)
{
    ImGui::PushStyleColor(ImGuiCol_Text, on ? colour::accent : colour::text);
    bool pressed = ImGui::Button((std::string(icon) + "##" + std::string(name)).c_str(), {0, frame.theme.row()});
    ImGui::PopStyleColor();
    frame.rects.mark(name);
    return pressed;
}

// A button that opens a list of choices, one of which holds.
template <typename Kind>
void choose(FrameContext& frame, const std::string& name, const char* icon, const std::vector<Kind>& choices,
            const std::string& help, std::string& chosen, bool with_words)
{
    const Kind* held = find_choice(choices, chosen);
    std::string words = held ? held->title : chosen;
    std::string label = std::string(icon) + (with_words ? " " + words + "  " : " ") + icon::chevron_down + "##" + name;
    bool pressed = ImGui::Button(label.c_str(), {0, frame.theme.row()});
    frame.rects.mark(name);
    ImVec2 below(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + frame.theme.gap());
    if (!ImGui::IsPopupOpen(name.c_str())) tooltip(help, "");
    if (pressed) ImGui::OpenPopup(name.c_str());
    ImGui::SetNextWindowPos(below);
    if (!ImGui::BeginPopup(name.c_str())) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {frame.theme.px(8), frame.theme.row() - ImGui::GetFontSize()});
    for (const Kind& choice : choices) {
        if (ImGui::MenuItem(choice.title.c_str(), nullptr, choice.name == chosen)) chosen = choice.name;
        frame.rects.mark(name + "/" + choice.name);
        if (ImGui::IsItemHovered()) frame.view.hint = choice.help;
    }
    ImGui::PopStyleVar();
    ImGui::EndPopup();
}

struct Ink {
    ImDrawList& list;
    ImFont& font;
    ImVec2 size(const char* text) const { return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text); }
    void write(ImVec2 at, ImU32 colour, const char* text) const
    {
        list.AddText(&font, font.FontSize, {std::round(at.x), std::round(at.y)}, colour, text);
    }
};

// What there is room for.
std::string statistics_line(const FrameContext& frame, const Ink& ink, float room)
{
    const PictureReading& picture = frame.readings.picture;
    std::string note = picture.compiling ? "Compiling shader…" : "";
    if (note.empty() && picture.full && picture.samples < picture.samples_wanted)
        note = "Sample " + std::to_string(picture.samples) + " of " + std::to_string(picture.samples_wanted);
    if (note.empty() && frame.view.stereo != "off" && !has_stereo(frame.readings, frame.view))
        note = "Stereo is off in this view";
    if (!frame.view.statistics || !picture.texture) return note;
    std::string rest = note.empty() ? "" : " · " + note;
    bool has_rays = frame.view.view != "slice";
    for (const std::string& line : {has_rays ? statistics_text(picture) + rest : short_statistics_text(picture) + rest,
                                    short_statistics_text(picture) + rest})
        if (ink.size(line.c_str()).x <= room) return line;
    return note;
}

}  // namespace

bool has_stereo(const Readings& readings, const ViewState& view)
{
    const ViewChoice* shown = find_choice(readings.views, view.view);
    const StereoChoice* mode = find_choice(readings.stereo_modes, view.stereo);
    if (!shown || !mode || view.stereo == "off" || view.view == "slice") return false;
    return shown->light || !mode->mixes;
}

std::string statistics_text(const PictureReading& picture)
{
    std::string steps = " · " + rounded_text(picture.mean_steps) + " steps mean, " + grouped_text(picture.max_steps) +
                        " max · " + percent_text(picture.exhausted_share) + " out of steps";
    return short_statistics_text(picture) + steps;
}

std::string short_statistics_text(const PictureReading& picture)
{
    return std::to_string(picture.width) + " × " + std::to_string(picture.height) + " · " + picture.device + " · " +
           duration_text(picture.draw_ms);
}

void draw_toolbar(FrameContext& frame, Viewport& viewport, const WidgetRect& pane)
{
    ToolbarStyle style(frame.theme);
    ViewState& view = frame.view;
    float width = pane.high.x - pane.low.x, inset = frame.theme.px(inset_px);
    bool with_words = width >= frame.theme.px(roomy_px);
    ImGui::SetCursorScreenPos({pane.low.x + inset, pane.low.y + inset});
    choose(frame, "viewport/view", icon::image, frame.readings.views, "What the picture shows", view.view, with_words);
    ImGui::SameLine();
    choose(frame, "viewport/stereo", icon::glasses, frame.readings.stereo_modes, "3D: a picture for each eye",
           view.stereo, with_words);
    ImGui::SameLine();
    bool through = viewport.looks_through_camera(frame);
    if (toggle(frame, icon::camera, through, "viewport/through_camera")) viewport.look_through_camera(frame);
    tooltip(through ? "Leave the scene's camera" : "Look through the scene's camera", "view.through_camera");
    ImGui::SameLine();
    if (toggle(frame, icon::move, view.gizmo, "viewport/gizmo")) viewport.toggle_gizmo(frame);
    tooltip(view.gizmo ? "Hide the handles that move a solid" : "Show the handles that move a solid", "view.gizmo");
}

void draw_statistics(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane)
{
    const PictureReading& picture = frame.readings.picture;
    const Theme& theme = frame.theme;
    if (!picture.full && picture.progress > 0) {
        float end = glm::mix(pane.low.x, pane.high.x, std::min(picture.progress, 1.0f));
        list.AddRectFilled({pane.low.x, pane.high.y - theme.px(2)}, {end, pane.high.y},
                           colour::with_alpha(colour::text, 0.7f));
    }
    Ink ink{list, *theme.fonts.small};
    ImVec2 inner(theme.px(8), theme.px(4));
    float inset = theme.px(inset_px), room = pane.high.x - pane.low.x - 2 * inset - 2 * inner.x;
    std::string text = statistics_line(frame, ink, room);
    if (text.empty()) return;
    ImVec2 size = ink.size(text.c_str()), low(pane.low.x + inset, pane.high.y - inset - size.y - 2 * inner.y);
    ImVec2 high(low.x + size.x + 2 * inner.x, low.y + size.y + 2 * inner.y);
    list.AddRectFilled(low, high, colour::veil, theme.px(6));
    ink.write({low.x + inner.x, low.y + inner.y}, colour::with_alpha(colour::text, 0.85f), text.c_str());
    frame.rects.mark("viewport/statistics", {{low.x, low.y}, {high.x, high.y}});
}

void draw_legend(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane)
{
    std::optional<Legend> legend = legend_of(frame, frame.view.view);
    if (!legend) return;
    const Theme& theme = frame.theme;
    Ink ink{list, *theme.fonts.small};
    float line = ink.font.FontSize, pad = theme.px(8), gap = theme.px(4), width = theme.px(176);
    bool above_statistics = pane.high.x - pane.low.x < theme.px(legend_beside_px);
    float lift = theme.px(inset_px) + (above_statistics ? line + theme.px(12) : 0);
    float rows = legend->marks_exhausted ? 3 : 2;
    ImVec2 high(pane.high.x - theme.px(inset_px), pane.high.y - lift);
    ImVec2 low(high.x - width - 2 * pad, high.y - rows * (line + gap) - theme.px(12) - 2 * pad + gap);
    list.AddRectFilled(low, high, colour::veil, theme.px(6));
    frame.rects.mark("viewport/legend", {{low.x, low.y}, {high.x, high.y}});
    ImVec2 at(low.x + pad, low.y + pad);
    ink.write(at, colour::text, legend->title.c_str());
    at.y += line + gap;
    at.y += draw_legend_bar(frame, list, at, width, *legend) + gap;
    if (!legend->marks_exhausted) return;
    float square = theme.px(8);
    list.AddRectFilled({at.x, at.y + theme.px(2)}, {at.x + square, at.y + theme.px(2) + square},
                       IM_COL32(255, 0, 255, 255), 2);
    ink.write({at.x + square + gap, at.y}, colour::quiet_text, "Out of steps");
}

void draw_waiting(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane)
{
    Ink ink{list, *frame.theme.fonts.text};
    const char* text = "Drawing the first picture…";
    ImVec2 size = ink.size(text);
    glm::vec2 middle = pane.centre();
    ink.write({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, colour::quiet_text, text);
}

}  // namespace fieldwright::ui
