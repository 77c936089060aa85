// Drawing what lies over the picture.
#include "ui/viewport_overlay.h"

#include "ui/commands.h"
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

struct Words {
    std::string_view name, words;
};
constexpr Words views[] = {
    {"beauty", "Beauty"}, {"steps", "Steps heatmap"}, {"normal", "Normal"}, {"depth", "Depth"}, {"id", "Nodes"}};
constexpr Words stereos[] = {{"off", "Stereo off"}, {"naive", "Naive anaglyph"}, {"dubois", "Dubois anaglyph"}};

template <std::size_t count>
std::string words_of(const Words (&list)[count], std::string_view name)
{
    for (const Words& entry : list)
        if (entry.name == name) return std::string(entry.words);
    std::string words(name);
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] -= 'a' - 'A';
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

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

using WordsOf = std::string (*)(std::string_view);

struct Menu {
    std::string name;  // "viewport/view"
    const char* icon;
    const std::vector<std::string>& choices;
    WordsOf words;
    std::string help;
};

// A button that opens a list of choices, one of which holds.
void choose(FrameContext& frame, const Menu& menu, std::string& chosen, bool with_words)
{
    std::string label = std::string(menu.icon) + (with_words ? " " + menu.words(chosen) + "  " : " ") +
                        icon::chevron_down + "##" + menu.name;
    bool pressed = ImGui::Button(label.c_str(), {0, frame.theme.row()});
    frame.rects.mark(menu.name);
    ImVec2 below(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + frame.theme.gap());
    if (!ImGui::IsPopupOpen(menu.name.c_str())) tooltip(menu.help, "");
    if (pressed) ImGui::OpenPopup(menu.name.c_str());
    ImGui::SetNextWindowPos(below);
    if (!ImGui::BeginPopup(menu.name.c_str())) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {frame.theme.px(8), frame.theme.row() - ImGui::GetFontSize()});
    for (const std::string& choice : menu.choices) {
        if (ImGui::MenuItem(menu.words(choice).c_str(), nullptr, choice == chosen)) chosen = choice;
        frame.rects.mark(menu.name + "/" + choice);
    }
    ImGui::PopStyleVar();
    ImGui::EndPopup();
}

void draw_time(FrameContext& frame)
{
    ViewState& view = frame.view;
    if (toggle(frame, view.playing ? icon::pause : icon::play, view.playing, "viewport/play"))
        view.playing = !view.playing;
    tooltip(view.playing ? "Pause time" : "Play time", "render.play");
    ImGui::SameLine();
    float seconds = static_cast<float>(view.time_s);
    ImGui::SetNextItemWidth(frame.theme.px(96));
    // A knob would hide the number.
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, IM_COL32(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, IM_COL32(0, 0, 0, 0));
    if (ImGui::SliderFloat("##time", &seconds, 0, static_cast<float>(view.loop_s), "%.2f s",
                           ImGuiSliderFlags_AlwaysClamp))
        view.time_s = seconds;
    ImGui::PopStyleColor(2);
    frame.rects.mark("viewport/time");
    ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    float inset = frame.theme.px(6), share = std::clamp(static_cast<float>(view.time_s / view.loop_s), 0.0f, 1.0f);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x + inset, high.y - frame.theme.px(4)},
                       {glm::mix(low.x + inset, high.x - inset, share), high.y - frame.theme.px(2)}, colour::text, 1);
    tooltip("Time of the scene", "");
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
    if (note.empty() && frame.view.stereo != "off" && !has_stereo(frame.view.view)) note = "Stereo is off in this view";
    if (!frame.view.statistics || !picture.texture) return note;
    std::string rest = note.empty() ? "" : " · " + note;
    for (const std::string& line : {statistics_text(picture) + rest, short_statistics_text(picture) + rest})
        if (ink.size(line.c_str()).x <= room) return line;
    return note;
}

}  // namespace

std::string view_words(std::string_view view) { return words_of(views, view); }
bool has_stereo(std::string_view view) { return view == "beauty"; }
std::string stereo_words(std::string_view stereo) { return words_of(stereos, stereo); }

bool depends_on_time(const Readings& readings)
{
    if (!readings.program || readings.program->time == graph::no_value) return false;
    const std::vector<graph::ValueId>& used = readings.program->arguments;
    return std::find(used.begin(), used.end(), readings.program->time) != used.end();
}

ImU32 heatmap(float share)
{
    constexpr float coefficients[7][3] = {{-2.0005f, 5.0472f, 31.9606f},  {-6.7884f, -14.7948f, -81.8892f},
                                          {21.0564f, 15.0598f, 74.8316f}, {-13.586f, -6.0118f, -28.5667f},
                                          {2.1678f, 0.186f, 2.2625f},     {-0.1429f, 1.4141f, 1.2013f},
                                          {0.2769f, 0.0052f, 0.3343f}};
    float u = std::clamp(share, 0.0f, 1.0f);
    glm::vec3 sum(0);
    for (const auto& c : coefficients) sum = sum * u + glm::vec3(c[0], c[1], c[2]);
    return ImGui::ColorConvertFloat4ToU32({sum.r, sum.g, sum.b, 1});
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
    choose(frame, {"viewport/view", icon::image, frame.readings.view_names, view_words, "What the picture shows"},
           view.view, with_words);
    ImGui::SameLine();
    choose(frame,
           {"viewport/stereo", icon::glasses, frame.readings.stereo_names, stereo_words, "3D for red-cyan glasses"},
           view.stereo, with_words);
    ImGui::SameLine();
    bool through = viewport.looks_through_camera(frame);
    if (toggle(frame, icon::camera, through, "viewport/through_camera")) viewport.look_through_camera(frame);
    tooltip(through ? "Leave the scene's camera" : "Look through the scene's camera", "view.through_camera");
    ImGui::SameLine();
    if (toggle(frame, icon::move, view.gizmo, "viewport/gizmo")) viewport.toggle_gizmo(frame);
    tooltip(view.gizmo ? "Hide the handles that move a solid" : "Show the handles that move a solid", "view.gizmo");
    if (!depends_on_time(frame.readings)) return;
    if (width >= frame.theme.px(640)) ImGui::SameLine();
    else ImGui::SetCursorScreenPos({pane.low.x + inset, ImGui::GetItemRectMax().y + frame.theme.gap()});
    draw_time(frame);
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

void draw_steps_legend(const FrameContext& frame, ImDrawList& list, const WidgetRect& pane)
{
    if (frame.view.view != "steps") return;
    const Theme& theme = frame.theme;
    Ink ink{list, *theme.fonts.small};
    float line = ink.font.FontSize, pad = theme.px(8), gap = theme.px(4), bar = theme.px(8), width = theme.px(176);
    bool above_statistics = pane.high.x - pane.low.x < theme.px(legend_beside_px);
    float lift = theme.px(inset_px) + (above_statistics ? line + theme.px(12) : 0);
    ImVec2 high(pane.high.x - theme.px(inset_px), pane.high.y - lift);
    ImVec2 low(high.x - width - 2 * pad, high.y - 3 * line - 3 * gap - bar - 2 * pad);
    list.AddRectFilled(low, high, colour::veil, theme.px(6));
    frame.rects.mark("viewport/legend", {{low.x, low.y}, {high.x, high.y}});
    ImVec2 at(low.x + pad, low.y + pad);
    ink.write(at, colour::text, "Steps per ray");
    at.y += line + gap;
    constexpr int bands = 44;
    for (int i = 0; i < bands; ++i) {
        float from = static_cast<float>(i) / bands, to = static_cast<float>(i + 1) / bands;
        list.AddRectFilledMultiColor({at.x + from * width, at.y}, {at.x + to * width, at.y + bar}, heatmap(from),
                                     heatmap(to), heatmap(to), heatmap(from));
    }
    at.y += bar + gap;
    int limit = frame.draft.document.march.step_limit;
    std::string half = std::to_string(limit / 2), most = std::to_string(limit);
    ink.write(at, colour::quiet_text, "0");
    ink.write({at.x + 0.5f * (width - ink.size(half.c_str()).x), at.y}, colour::quiet_text, half.c_str());
    ink.write({at.x + width - ink.size(most.c_str()).x, at.y}, colour::quiet_text, most.c_str());
    at.y += line + gap;
    list.AddRectFilled({at.x, at.y + theme.px(2)}, {at.x + bar, at.y + theme.px(2) + bar}, IM_COL32(255, 0, 255, 255),
                       2);
    ink.write({at.x + bar + gap, at.y}, colour::quiet_text, "Out of steps");
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
