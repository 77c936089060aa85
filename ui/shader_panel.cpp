// Drawing thousands of lines of GLSL: only the rows in view are coloured.
#include "ui/shader_panel.h"

#include "ui/glsl_highlight.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>

namespace fieldwright::ui {
namespace {

constexpr std::uint32_t continuation_columns = 2;  // a broken line goes on indented by this

// At most `room` bytes, behind a blank where one is near.
std::uint32_t end_of_row(std::string_view text, std::uint32_t first, std::uint32_t last, std::uint32_t room)
{
    if (last - first <= room) return last;
    std::size_t blank = text.rfind(' ', first + room);
    return blank != std::string_view::npos && blank > first + room / 2 ? static_cast<std::uint32_t>(blank + 1)
                                                                       : first + room;
}

std::string target_title(std::string_view target)
{
    if (target == "glsl") return "GLSL";
    if (target == "shadertoy") return "Shadertoy";
    return in_words(target);
}

}  // namespace

void ShaderPanel::draw(FrameContext& frame)
{
    toolbar(frame);
    if (!frame.readings.shader_text) {
        text_ = nullptr;
        empty_state(frame, icon::code, "The shader text of the scene is on its way.");
        return;
    }
    ImGui::PushFont(frame.theme.fonts.mono);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::window);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.theme.px(4), frame.theme.px(4)));
    ImGui::BeginChild("code", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    frame.rects.mark("panel/shader/code");
    bool fresh = text_ != frame.readings.shader_text;
    if (fresh) {
        text_ = frame.readings.shader_text;
        read_lines();
    }
    float column_px = ImGui::GetFont()->GetCharAdvance('0');
    float gutter_px = column_px * static_cast<float>(std::to_string(lines_.size()).size() + 2);
    float room = (ImGui::GetContentRegionAvail().x - gutter_px) / column_px;
    auto columns = static_cast<std::uint32_t>(std::max(room, 16.0f));
    if (fresh || columns != columns_) break_lines(columns);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.size()), ImGui::GetFontSize() + frame.theme.px(4));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_row(frame, rows_[static_cast<std::size_t>(i)], gutter_px, column_px);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void ShaderPanel::toolbar(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    ImGui::BeginDisabled(!frame.readings.shader_text);
    if (text_button(frame, "copy", std::string(icon::copy) + "  Copy"))
        ImGui::SetClipboardText(frame.readings.shader_text->c_str());
    ImGui::EndDisabled();
    frame.rects.mark("panel/shader/copy");
    for (const std::string& target : frame.readings.export_targets) {
        std::string label = "Export " + target_title(target) + "…";
        ImGui::SameLine(0, theme.gap());
        float width = ImGui::CalcTextSize(label.c_str()).x + theme.px(20);
        if (width > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
        if (text_button(frame, target.c_str(), label))
            frame.requests.push_back(ChooseFile{ChooseFile::Then::export_shader, target});
        frame.rects.mark("panel/shader/export/" + target);
    }
}

void ShaderPanel::read_lines()
{
    lines_.clear();
    bool in_comment = false;
    std::string_view text = *text_;
    for (std::size_t first = 0; first < text.size();) {
        std::size_t last = std::min(text.find('\n', first), text.size());
        lines_.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), in_comment});
        // Most shaders have no block comment; only where one may open are the tokens needed.
        std::string_view line = text.substr(first, last - first);
        if (in_comment || line.find("/*") != std::string_view::npos) glsl_tokens(line, in_comment);
        first = last + 1;
    }
}

void ShaderPanel::break_lines(std::uint32_t columns)
{
    columns_ = columns;
    rows_.clear();
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
        std::uint32_t first = lines_[i].first, room = columns;
        do {
            std::uint32_t last = end_of_row(*text_, first, lines_[i].last, room);
            rows_.push_back({i, first, last, first == lines_[i].first});
            first = last;
            room = columns - continuation_columns;
        } while (first < lines_[i].last);
    }
}

void ShaderPanel::draw_row(FrameContext& frame, const Row& row, float gutter_px, float column_px) const
{
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImGui::Dummy({1, ImGui::GetFontSize() + frame.theme.px(4)});
    if (row.begins_line) {
        std::string number = std::to_string(row.line + 1);
        float x = low.x + gutter_px - column_px * static_cast<float>(number.size() + 1);
        draw.AddText({x, low.y}, colour::rgb(0x566070), number.c_str());
    }
    const Line& line = lines_[row.line];
    const char* base = text_->data();
    bool in_comment = line.in_comment;
    float indent = row.begins_line ? 0 : static_cast<float>(continuation_columns);
    for (const GlslToken& token : glsl_tokens({base + line.first, line.last - line.first}, in_comment)) {
        auto first = std::max(line.first + static_cast<std::uint32_t>(token.first), row.first);
        auto last = std::min(line.first + static_cast<std::uint32_t>(token.last), row.last);
        if (first >= last) continue;
        float x = low.x + gutter_px + column_px * (static_cast<float>(first - row.first) + indent);
        draw.AddText({x, low.y}, glsl_colour(token.kind), base + first, base + last);
    }
}

}  // namespace fieldwright::ui
