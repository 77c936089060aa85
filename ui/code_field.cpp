// Dear ImGui's text field with its letters unseen, over the same text in colours. It is as large as its text and the
// child around it scrolls, so that both stay one above the other.
#include "ui/code_field.h"

#include "ui/glsl_highlight.h"
#include "ui/keys.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr int indent_columns = 4;
constexpr double blink_s = 1.2, lit_s = 0.8;

std::vector<std::string_view> lines_of(std::string_view text)
{
    std::vector<std::string_view> lines;
    for (std::size_t first = 0; first <= text.size();) {
        std::size_t last = std::min(text.find('\n', first), text.size());
        lines.push_back(text.substr(first, last - first));
        first = last + 1;
    }
    return lines;
}

// Letters, not bytes.
int columns_of(std::string_view line)
{
    return static_cast<int>(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

struct Place {
    int line, column;
};

Place place_of(std::string_view text, int byte)
{
    std::string_view before = text.substr(0, static_cast<std::size_t>(byte));
    std::size_t line_end = before.rfind('\n');
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')),
            columns_of(line_end == before.npos ? before : before.substr(line_end + 1))};
}

// What a line that follows this one begins with.
std::string indent_after(std::string_view line)
{
    std::string indent(line.substr(0, std::min(line.find_first_not_of(' '), line.size())));
    std::size_t last = line.find_last_not_of(' ');
    if (last != line.npos && line[last] == '{') indent.append(indent_columns, ' ');
    return indent;
}

ImU32 tint_of_line(bool wrong) { return wrong ? colour::error : colour::rgb(0x566070); }

}  // namespace

// Blanks for a tab, and a new line begins where the last one did.
int CodeField::on_edit(ImGuiInputTextCallbackData* data)
{
    auto& field = *static_cast<CodeField*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
        int at = data->CursorPos;
        if (at > 0 && data->Buf[at - 1] == '\t') {
            data->DeleteChars(at - 1, 1);
            data->InsertChars(at - 1, std::string(indent_columns, ' ').c_str());
        } else if (at > 0 && data->Buf[at - 1] == '\n' && data->BufTextLen == field.length_ + 1) {
            std::string_view before(data->Buf, static_cast<std::size_t>(at - 1));
            std::size_t line = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
            data->InsertChars(at, indent_after(before.substr(line)).c_str());
        }
    }
    field.cursor_ = data->CursorPos;
    field.length_ = data->BufTextLen;
    return 0;
}

CodeField::Outcome CodeField::draw(FrameContext& frame, const std::string& path, std::string& text, int wrong_line,
                                   float height_px)
{
    Outcome outcome;
    ImGui::PushFont(frame.theme.fonts.mono);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::window);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.theme.px(4), frame.theme.px(4)));
    ImGui::BeginChild(path.c_str(), {0, height_px}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_HorizontalScrollbar);
    std::vector<std::string_view> lines = lines_of(text);
    int longest = 0;
    for (std::string_view line : lines) longest = std::max(longest, columns_of(line));
    Layout layout;
    layout.letter_px = ImGui::GetFont()->GetCharAdvance('0');
    layout.line_px = ImGui::GetFontSize();
    layout.gutter_px = layout.letter_px * static_cast<float>(std::to_string(lines.size()).size() + 2);
    ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    layout.origin = {corner.x + layout.gutter_px, corner.y};
    ImVec2 size(std::max(room.x - layout.gutter_px, layout.letter_px * static_cast<float>(longest + 2)),
                std::max(room.y, layout.line_px * static_cast<float>(lines.size() + 1)));
    paint(text, layout, wrong_line);
    if (active_) paint_cursor(text, layout);

    ImGui::SetCursorScreenPos(layout.origin);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_Text, 0u);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0u);
    ImGui::PushStyleColor(ImGuiCol_TextSelectedBg, colour::with_alpha(colour::accent, 0.3f));
    ImGuiID id = ImGui::GetID("##text");
    // Else the key would take back what was typed since the field was entered.
    if (ImGui::GetActiveID() == id && ImGui::IsKeyPressed(key::escape, false)) ImGui::ClearActiveID();
    outcome.edited = ImGui::InputTextMultiline(
        "##text", &text, size,
        ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_CallbackEdit | ImGuiInputTextFlags_CallbackAlways,
        on_edit, this);
    bool was_active = std::exchange(active_, ImGui::GetActiveID() == id);
    outcome.left = was_active && !active_;
    ImGui::PopStyleColor(3);
    ImGui::PopStyleVar(2);
    if (active_) follow_cursor(text, layout);
    ImGui::EndChild();
    frame.rects.mark(path);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    return outcome;
}

void CodeField::paint(const std::string& text, const Layout& layout, int wrong_line) const
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 window = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    std::vector<std::string_view> lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        float y = layout.origin.y + layout.line_px * static_cast<float>(i);
        if (y + layout.line_px < window.y || y > window.y + size.y) continue;
        bool wrong = static_cast<int>(i) + 1 == wrong_line;
        if (wrong)
            draw.AddRectFilled({window.x, y}, {window.x + size.x, y + layout.line_px},
                               colour::with_alpha(colour::error, 0.16f));
        std::string number = std::to_string(i + 1);
        float x = layout.origin.x - layout.letter_px * static_cast<float>(number.size() + 1);
        draw.AddText({x, y}, tint_of_line(wrong), number.c_str());
        bool in_comment = false;  // the dialect has none of several lines
        for (const GlslToken& token : glsl_tokens(lines[i], in_comment)) {
            std::string_view before = lines[i].substr(0, token.first);
            const char* begin = lines[i].data() + token.first;
            draw.AddText({layout.origin.x + layout.letter_px * static_cast<float>(columns_of(before)), y},
                         glsl_colour(token.kind), begin, lines[i].data() + token.last);
        }
    }
}

void CodeField::paint_cursor(const std::string& text, const Layout& layout) const
{
    if (std::fmod(ImGui::GetTime(), blink_s) > lit_s) return;
    Place place = place_of(text, std::min(cursor_, static_cast<int>(text.size())));
    float x = std::floor(layout.origin.x + layout.letter_px * static_cast<float>(place.column));
    float y = layout.origin.y + layout.line_px * static_cast<float>(place.line);
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x, y + layout.line_px}, colour::text);
}

// The line of the cursor stays in view while it moves.
void CodeField::follow_cursor(const std::string& text, const Layout& layout)
{
    if (std::exchange(followed_, cursor_) == cursor_) return;
    Place place = place_of(text, std::min(cursor_, static_cast<int>(text.size())));
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    float y = layout.line_px * static_cast<float>(place.line),
          bottom = y + 2 * layout.line_px - window.InnerRect.GetHeight();
    float x = layout.letter_px * static_cast<float>(place.column);
    float right = x + layout.gutter_px + 4 * layout.letter_px - window.InnerRect.GetWidth();
    if (y < window.Scroll.y) ImGui::SetScrollY(y);
    else if (bottom > window.Scroll.y) ImGui::SetScrollY(bottom);
    if (x < window.Scroll.x) ImGui::SetScrollX(x);
    else if (right > window.Scroll.x) ImGui::SetScrollX(right);
}

}  // namespace fieldwright::ui
