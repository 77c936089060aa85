// The clock of the animation, and its bar.
#include "ui/transport.h"

#include "graph/settings.h"
#include "ui/commands.h"
#include "ui/number_text.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fieldwright::ui {
namespace {

constexpr float roomy_px = 420;  // narrower panes have no buttons for single frames; design px

// Of a button that does what a command does.
bool button(FrameContext& frame, const char* icon, std::string_view command, const char* tip, bool lit = false)
{
    std::string name = "viewport/" + std::string(command.substr(command.find('.') + 1));
    bool pressed =
        icon_button(frame, name.c_str(), icon, with_shortcut(tip, command), lit ? colour::accent : colour::text, lit);
    frame.rects.mark(name);
    ImGui::SameLine(0, frame.theme.px(2));
    return pressed;
}

// A line along which the frames lie, and a knob on it.
void draw_frames(FrameContext& frame, float width_px)
{
    const graph::AnimationSettings& animation = frame.draft.document.animation;
    ViewState& view = frame.view;
    ImVec2 low = ImGui::GetCursorScreenPos(), size(std::max(width_px, 1.0f), frame.theme.row());
    ImGui::InvisibleButton("viewport/time", size);
    frame.rects.mark("viewport/time");
    float inset = frame.theme.px(7), from = low.x + inset, to = low.x + size.x - inset, y = low.y + 0.5f * size.y;
    int frames = animation.last_frame - animation.first_frame;
    if (ImGui::IsItemActive()) {
        float share = std::clamp((ImGui::GetIO().MousePos.x - from) / std::max(to - from, 1.0f), 0.0f, 1.0f);
        go_to_frame(view, animation,
                    animation.first_frame + static_cast<int>(std::lround(share * static_cast<float>(frames))));
    }
    bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    int at = shown_frame(animation, view.time_s) - animation.first_frame;
    float share = frames > 0 ? std::clamp(static_cast<float>(at) / static_cast<float>(frames), 0.0f, 1.0f) : 0.0f;
    float knob = glm::mix(from, to, share), half = frame.theme.px(1);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({from, y - half}, {to, y + half}, colour::with_alpha(colour::text, 0.3f), half);
    list.AddRectFilled({from, y - half}, {knob, y + half}, colour::text, half);
    list.AddCircleFilled({knob, y}, frame.theme.px(hot ? 6.0f : 5.0f), hot ? colour::accent : colour::text);
}

std::string clock_text(const FrameContext& frame)
{
    const graph::AnimationSettings& animation = frame.draft.document.animation;
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.2f s", frame.view.time_s);
    return "Frame " + std::to_string(shown_frame(animation, frame.view.time_s)) + " of " +
           std::to_string(animation.last_frame) + "  ·  " + seconds;
}

}  // namespace

bool depends_on_time(const Readings& readings)
{
    if (!readings.program || readings.program->time == graph::no_value) return false;
    const std::vector<graph::ValueId>& used = readings.program->arguments;
    return std::find(used.begin(), used.end(), readings.program->time) != used.end();
}

int shown_frame(const graph::AnimationSettings& animation, double time_s)
{
    double frame = 1 + time_s * static_cast<double>(animation.frames_per_second);
    return static_cast<int>(std::lround(std::clamp(frame, -2e6, 2e6)));
}

void go_to_frame(ViewState& view, const graph::AnimationSettings& animation, int frame)
{
    int inside = std::clamp(frame, animation.first_frame, animation.last_frame);
    view.time_s = static_cast<double>(graph::time_of_frame(animation, inside));
    view.frame_rest_s = 0;
}

void step_frames(ViewState& view, const graph::AnimationSettings& animation, int steps)
{
    int frames = animation.last_frame - animation.first_frame + 1;
    int at = std::clamp(shown_frame(animation, view.time_s), animation.first_frame, animation.last_frame);
    int offset = at - animation.first_frame + steps;
    if (view.looping) offset = (offset % frames + frames) % frames;
    go_to_frame(view, animation, animation.first_frame + offset);
}

void play_on(ViewState& view, const graph::AnimationSettings& animation, double passed_s)
{
    double frame_s = 1.0 / static_cast<double>(animation.frames_per_second);
    double rest = view.frame_rest_s + passed_s;
    auto steps = static_cast<int>(std::min(std::floor(rest / frame_s), 1e6));
    bool at_end = shown_frame(animation, view.time_s) + steps >= animation.last_frame;
    if (steps > 0) step_frames(view, animation, steps);
    view.frame_rest_s = rest - steps * frame_s;
    if (at_end && !view.looping) view.playing = false;
}

float transport_height(const FrameContext& frame)
{
    return depends_on_time(frame.readings) ? frame.theme.row() + frame.theme.px(8) : 0;
}

void draw_transport(FrameContext& frame, const WidgetRect& pane)
{
    float height = transport_height(frame);
    if (height == 0) return;
    const graph::AnimationSettings& animation = frame.draft.document.animation;
    ViewState& view = frame.view;
    ImGui::GetWindowDrawList()->AddRectFilled({pane.low.x, pane.high.y - height}, {pane.high.x, pane.high.y},
                                              colour::veil);
    float inset = frame.theme.px(8);
    bool roomy = pane.high.x - pane.low.x >= frame.theme.px(roomy_px);
    ImGui::SetCursorScreenPos({pane.low.x + inset, pane.high.y - height + frame.theme.px(4)});
    if (button(frame, icon::rewind, "render.start", "Go to the first frame"))
        go_to_frame(view, animation, animation.first_frame);
    if (roomy && button(frame, icon::backward, "render.previous_frame", "Go back a frame"))
        step_frames(view, animation, -1);
    if (button(frame, view.playing ? icon::pause : icon::play, "render.play", view.playing ? "Pause" : "Play",
               view.playing))
        view.playing = !view.playing;
    if (roomy && button(frame, icon::forward, "render.next_frame", "Go on a frame")) step_frames(view, animation, 1);
    if (button(frame, icon::loop, "render.loop",
               view.looping ? "Stop at the last frame" : "Begin again after the last frame", view.looping))
        view.looping = !view.looping;

    ImGui::PushFont(frame.theme.fonts.small);
    std::string clock = clock_text(frame);
    float words = ImGui::CalcTextSize(clock.c_str()).x, line = ImGui::GetTextLineHeight();
    float left = ImGui::GetCursorScreenPos().x;
    if (roomy)
        ImGui::GetWindowDrawList()->AddText({pane.high.x - inset - words, pane.high.y - 0.5f * (height + line)},
                                            colour::text, clock.c_str());
    ImGui::PopFont();
    draw_frames(frame, pane.high.x - inset - (roomy ? words + inset : 0) - left);
    frame.rects.mark("viewport/transport", {{pane.low.x, pane.high.y - height}, {pane.high.x, pane.high.y}});
}

}  // namespace fieldwright::ui
