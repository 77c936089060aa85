// Dear ImGui's text fields over a buffer of the longest text.
#include "ui/words_field.h"

#include "graph/limits.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cstring>

namespace fieldwright::ui {
namespace {

constexpr std::ptrdiff_t most_lines = 8;  // shown at once

struct Buffer {
    explicit Buffer(const std::string& text)
    {
        std::memcpy(bytes, text.data(), std::min(text.size(), sizeof bytes - 1));
    }
    char bytes[graph::text_limit + 1] = {};
};

}  // namespace

bool text_field(const FrameContext& frame, const char* id, std::string& text, float width_px)
{
    Buffer buffer(text);
    RowPadding padding(frame.theme);
    auto lines = static_cast<float>(std::min(1 + std::count(text.begin(), text.end(), '\n'), most_lines));
    float height = frame.theme.row() + (lines - 1) * ImGui::GetTextLineHeight();
    if (!ImGui::InputTextMultiline(id, buffer.bytes, sizeof buffer.bytes, {width_px, height})) return false;
    text = buffer.bytes;
    return true;
}

bool formula_field(const FrameContext& frame, const char* id, std::string& text, float width_px)
{
    Buffer buffer(text);
    ImGui::PushFont(frame.theme.fonts.mono);
    RowPadding padding(frame.theme);
    ImGui::SetNextItemWidth(width_px);
    bool changed = ImGui::InputText(id, buffer.bytes, sizeof buffer.bytes);
    ImGui::PopFont();
    if (changed) text = buffer.bytes;
    return changed;
}

}  // namespace fieldwright::ui
