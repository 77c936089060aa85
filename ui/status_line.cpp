// What the status line says, and drawing it.
#include "ui/status_line.h"

#include "graph/words.h"

#include <imgui_internal.h>

#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr double shown_s = 4;    // refusals and news
constexpr double flash_s = 0.6;  // of news, so that the same again is seen

std::string scene_text(const FrameContext& frame)
{
    std::size_t nodes = frame.draft.document.root.nodes.size();
    std::string text = std::to_string(nodes) + (nodes == 1 ? " node" : " nodes");
    const Readings& readings = frame.readings;
    if (readings.frames_per_second >= 0.5)
        text += " · " + std::to_string(std::lround(readings.frames_per_second)) + " fps";
    if (!readings.picture.device.empty()) text += " · " + readings.picture.device;
    return text;
}

}  // namespace

void StatusLine::refuse(std::string_view sentence, double now_s)
{
    refusal_ = graph::as_sentence(sentence);
    refused_at_s_ = now_s;
}

void StatusLine::note_status(const Readings& readings, double now_s)
{
    if (readings.status_count == status_count_) return;
    status_count_ = readings.status_count;
    status_ = readings.status;
    status_at_s_ = now_s;
    refusal_.clear();
}

StatusLine::Message StatusLine::message(const FrameContext& frame, double now_s)
{
    note_status(frame.readings, now_s);
    changes_at_s_.reset();
    if (!refusal_.empty() && now_s < refused_at_s_ + shown_s) {
        changes_at_s_ = refused_at_s_ + shown_s;
        return {refusal_, colour::error};
    }
    refusal_.clear();
    if (!status_.empty() && frame.readings.status_is_error) return {status_, colour::error};
    if (!status_.empty() && now_s < status_at_s_ + shown_s) {
        bool fresh = now_s < status_at_s_ + flash_s;
        changes_at_s_ = status_at_s_ + (fresh ? flash_s : shown_s);
        return {status_, fresh ? colour::hot : colour::text};
    }
    return {frame.view.hint, colour::quiet_text};
}

void StatusLine::draw(FrameContext& frame, double now_s)
{
    const Theme& theme = frame.theme;
    ImVec2 window = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    float top = window.y + size.y - theme.status_line(), inset = theme.padding();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(theme.fonts.small);
    float y = top + std::floor((theme.status_line() - ImGui::GetTextLineHeight()) / 2);

    std::string right = scene_text(frame);
    float right_x = window.x + size.x - inset - ImGui::CalcTextSize(right.c_str()).x;
    list.AddText({right_x, y}, colour::quiet_text, right.c_str());

    Message left = message(frame, now_s);
    text_ = left.text;
    float left_x = window.x + inset, limit = right_x - theme.px(24);
    ImGui::PushStyleColor(ImGuiCol_Text, left.colour);
    ImGui::RenderTextEllipsis(&list, {left_x, y}, {limit, top + theme.status_line()}, limit, limit, left.text.c_str(),
                              nullptr, nullptr);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (!left.text.empty()) frame.rects.mark("status/left", {{left_x, top}, {limit, top + theme.status_line()}});
    frame.rects.mark("status/right", {{right_x, top}, {window.x + size.x, top + theme.status_line()}});
}

}  // namespace fieldwright::ui
