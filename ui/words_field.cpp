// Dear ImGui's text fields over a buffer of the longest text.
#include "ui/words_field.h"

#include "graph/formula.h"
#include "graph/limits.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

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

std::string joined(const std::vector<std::string_view>& words)
{
    std::string text;
    for (std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

bool is_readable(const std::string& formula, const graph::NodeType& type)
{
    return std::holds_alternative<graph::Formula>(graph::parse_formula(formula, type));
}

// What was typed into a field that another widget took the keyboard from before the field was drawn.
const char* left_behind(ImGuiID id)
{
    const ImGuiContext& context = *GImGui;
    bool was_active = context.ActiveIdPreviousFrame == id && context.ActiveId != id;
    return was_active && context.InputTextState.ID == id ? context.InputTextState.TextA.Data : nullptr;
}

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

FormulaField formula_field(FrameContext& frame, std::string_view path, const graph::NodeType& type,
                           const std::string& kept, float width_px)
{
    ImGuiID id = ImGui::GetID("##formula");
    FormulaField field{kept};
    if (const char* typed = left_behind(id)) field.shown = typed;
    bool left = field.shown != kept;
    Buffer buffer(field.shown);
    ImGui::PushFont(frame.theme.fonts.mono);
    {
        RowPadding padding(frame.theme);
        ImGui::SetNextItemWidth(width_px);
        ImGui::InputText("##formula", buffer.bytes, sizeof buffer.bytes);
    }
    ImGui::PopFont();
    frame.rects.mark(path);
    left = left || ImGui::IsItemDeactivated();
    field.shown = buffer.bytes;
    bool readable = is_readable(field.shown, type);
    field.keep = field.shown != kept && (left || readable);
    if (!readable)
        ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), colour::error,
                                            frame.theme.px(4), 0, frame.theme.px(1));
    return field;
}

void formula_complaint(FrameContext& frame, std::string_view path, const graph::NodeType& type,
                       const std::string& shown)
{
    graph::ParsedFormula parsed = graph::parse_formula(shown, type);
    const auto* error = std::get_if<graph::FormulaError>(&parsed);
    if (!error) return;
    paragraph(as_sentence(error->sentence()), colour::error);
    frame.rects.mark(std::string(path) + "/error");
}

std::string formula_name_list(const graph::NodeType& type) { return joined(graph::formula_names(type)); }

std::string formula_words(const graph::NodeType& type)
{
    std::string functions = joined(graph::formula_functions());
    return "Numbers: " + formula_name_list(type) +
           ", pi, tau, e.\nOperators: + - * / ^, comparisons, condition ? this : that.\nFunctions: " + functions + ".";
}

}  // namespace fieldwright::ui
