// Dragging, typing and drawing a number.
#include "ui/number_field.h"

#include "ui/number_text.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr double unlimited = 1e5;    // a soft range this wide is none
constexpr float full_drag_px = 400;  // design px that cover the soft range

double span_of(const NumberStyle& style) { return style.soft_maximum - style.soft_minimum; }
bool has_soft_range(const NumberStyle& style) { return span_of(style) < unlimited; }

// Decimals that matter: what a drag rounds to.
int decimals_of(const NumberStyle& style)
{
    if (style.whole) return 0;
    if (!has_soft_range(style)) return 2;
    double span = span_of(style);
    return span < 0.02 ? 5 : span < 0.3 ? 3 : span < 30 ? 2 : span < 300 ? 1 : 0;
}

// Small steps are shown when the value has them.
int shown_decimals(const NumberStyle& style) { return std::min(decimals_of(style), 3); }

double clamped(const NumberStyle& style, double value) { return std::clamp(value, style.minimum, style.maximum); }

// What the hand has added up since the drag began; kept by Dear ImGui under the field's id.
struct DragMemory {
    float &unrounded, &start;

    static DragMemory of(ImGuiID id)
    {
        ImGuiStorage& storage = *ImGui::GetStateStorage();
        // Both exist before a reference is taken: adding one may move the other.
        storage.GetFloatRef(id);
        storage.GetFloatRef(id + 1);
        return {*storage.GetFloatRef(id), *storage.GetFloatRef(id + 1)};
    }
};

double dragged(const FrameContext& frame, const NumberStyle& style, DragMemory memory, float moved_px)
{
    bool fine = ImGui::GetIO().KeyShift;
    double reach = has_soft_range(style) ? span_of(style) : std::max(2.0 * std::abs(memory.start), 4.0);
    double per_px = reach / frame.theme.px(full_drag_px) * (fine ? 0.1 : 1);
    bool starts_inside = memory.start >= style.soft_minimum && memory.start <= style.soft_maximum;
    double low = starts_inside ? std::max(style.soft_minimum, style.minimum) : style.minimum;
    double high = starts_inside ? std::min(style.soft_maximum, style.maximum) : style.maximum;
    double unrounded = std::clamp(memory.unrounded + per_px * moved_px, low, high);
    memory.unrounded = static_cast<float>(unrounded);
    double step = std::pow(10.0, -(decimals_of(style) + (fine && !style.whole ? 1 : 0)));
    return std::clamp(std::round(unrounded / step) * step, low, high);
}

bool drag(const FrameContext& frame, ImGuiID id, double& value, const NumberStyle& style)
{
    ImGuiContext& context = *GImGui;
    DragMemory memory = DragMemory::of(id);
    if (context.ActiveIdIsJustActivated) memory.unrounded = memory.start = static_cast<float>(value);
    double before = value;
    if (ImGui::IsKeyPressedMap(ImGuiKey_Escape)) {
        value = memory.start;
        ImGui::ClearActiveID();
    } else if (!context.IO.MouseDown[0]) {
        ImGui::ClearActiveID();
    } else if (context.IO.MouseDelta.x != 0 && ImGui::IsMouseDragPastThreshold(0, frame.theme.px(2))) {
        value = dragged(frame, style, memory, context.IO.MouseDelta.x);
    }
    if (value == before) return false;
    ImGui::MarkItemEdited(id);
    return true;
}

// Whether this frame asks to type into the field; makes it active when clicked.
bool asks_to_type(const ImRect& box, ImGuiID id)
{
    ImGuiContext& context = *GImGui;
    bool tabbed = context.LastItemData.StatusFlags & ImGuiItemStatusFlags_FocusedByTabbing;
    bool hovered = ImGui::ItemHoverable(box, id);
    if (hovered && context.ActiveId == 0) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    bool clicked = hovered && context.IO.MouseClicked[0];
    // From the next frame on: in this one the key would end the typing.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    bool entered = context.ActiveId == 0 && storage.GetBool(id + 2);
    storage.SetBool(id + 2,
                    hovered && context.ActiveId == 0 && !entered && ImGui::IsKeyPressedMap(ImGuiKey_Enter, false));
    if (entered) context.NavActivateInputId = id;
    if (clicked || tabbed || entered) {
        ImGui::SetActiveID(id, context.CurrentWindow);
        ImGui::SetFocusID(id, context.CurrentWindow);
        ImGui::FocusWindow(context.CurrentWindow);
    }
    return tabbed || entered || (clicked && (context.IO.KeyCtrl || context.IO.MouseClickedCount[0] == 2));
}

bool type(FrameContext& frame, const ImRect& box, const char* name_id, std::string_view name, double& value,
          const NumberStyle& style)
{
    ImGuiID id = GImGui->CurrentWindow->GetID(name_id);
    DragMemory memory = DragMemory::of(id);
    if (!ImGui::TempInputIsActive(id)) memory.start = static_cast<float>(value);
    char text[64];
    exact_text(value).copy(text, sizeof text - 1);
    text[std::min(exact_text(value).size(), sizeof text - 1)] = 0;
    RowPadding padding(frame.theme);
    if (!ImGui::TempInputText(box, id, name_id, text, sizeof text, ImGuiInputTextFlags_AutoSelectAll)) return false;
    double before = value;
    if (std::optional<double> typed = parse_number(text, style.unit))
        value = clamped(style, style.whole ? std::round(*typed) : *typed);
    else {
        value = memory.start;
        std::string wanted = style.whole ? "a whole number" : "a number";
        if (!style.unit.empty()) wanted += " of unit" + unit_suffix(style.unit == "deg" ? "degree" : style.unit);
        frame.draft.refusal =
            "“" + std::string(text) + "” is not " + wanted + "; " + std::string(name) + " stays as it was";
        ImGui::GetWindowDrawList()->AddRect(box.Min, box.Max, colour::error, frame.theme.px(4));
    }
    return value != before;
}

void draw_fill(const FrameContext& frame, const ImRect& box, double value, const NumberStyle& style)
{
    auto share = [&](double v) { return std::clamp((v - style.soft_minimum) / span_of(style), 0.0, 1.0); };
    auto zero = static_cast<float>(share(0)), end = static_cast<float>(share(value));
    float from = box.Min.x + box.GetWidth() * std::min(zero, end),
          to = box.Min.x + box.GetWidth() * std::max(zero, end);
    if (to - from < 1) return;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect({from, box.Min.y}, {to, box.Max.y}, true);
    draw.AddRectFilled(box.Min, box.Max, colour::rgb(0x3a4656), frame.theme.px(4));
    draw.PopClipRect();
}

void draw_number(const FrameContext& frame, const ImRect& box, ImGuiID id, double value, const NumberStyle& style)
{
    const Theme& theme = frame.theme;
    bool active = GImGui->ActiveId == id, hovered = GImGui->HoveredId == id;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(box.Min, box.Max,
                       ImGui::GetColorU32(hovered || active ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), theme.px(4));
    if (style.fill && has_soft_range(style)) draw_fill(frame, box, value, style);
    float x = box.Min.x + theme.px(8), y = box.Min.y + std::floor(0.5f * (box.GetHeight() - ImGui::GetFontSize()));
    if (*style.letter) {
        x = box.Min.x + theme.px(6);
        draw.AddText({x, y}, ImGui::GetColorU32(style.letter_tint), style.letter);
        x += theme.px(13);
    }
    std::string text = shown_number(value, style, box.Max.x - x - theme.px(4));
    draw.AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    if (active) draw.AddRect(box.Min, box.Max, colour::accent, theme.px(4));
}

float part_width(const Theme& theme, int count, float width_px)
{
    auto parts = static_cast<float>(count);
    return std::floor((width_px - theme.gap() * (parts - 1)) / parts);
}

}  // namespace

std::string shown_number(double value, const NumberStyle& style, float room_px)
{
    if (value == 0 && !style.at_zero.empty()) return style.at_zero;
    std::string suffix = style.show_unit ? unit_suffix(style.unit) : "";
    int decimals = shown_decimals(style);
    std::string number = style.whole ? number_text(std::round(value), 0) : number_text(value, decimals);
    if (ImGui::CalcTextSize((number + suffix).c_str()).x <= room_px) return number + suffix;
    for (int places = decimals; ImGui::CalcTextSize(number.c_str()).x > room_px && places >= 0; --places) {
        char text[48];
        std::snprintf(text, sizeof text, "%.*f", places, value);
        number = text;
    }
    return ImGui::CalcTextSize(number.c_str()).x <= room_px ? number : fitted(number, room_px);
}

bool vector_is_stacked(const Theme& theme, int count, float width_px)
{
    return part_width(theme, count, width_px) < theme.px(58);
}

NumberStyle number_style(const graph::Parameter& parameter)
{
    return {.minimum = parameter.minimum,
            .maximum = parameter.maximum,
            .soft_minimum = parameter.soft_minimum,
            .soft_maximum = parameter.soft_maximum,
            .unit = parameter.unit,
            .whole = parameter.kind == graph::ParameterKind::integer,
            .tip = parameter_tip(parameter)};
}

std::string parameter_tip(const graph::Parameter& parameter)
{
    std::string tip = parameter.help;
    if (!graph::has_range(parameter.kind) || parameter.kind == graph::ParameterKind::colour) return tip;
    std::string unit = unit_suffix(parameter.unit);
    if (!tip.empty()) tip += "\n";
    if (std::max(-parameter.minimum, parameter.maximum) >= 1e6 && parameter.minimum < 0)
        return tip + "Any number" + (unit.empty() ? "" : ", in" + unit) + ".";
    return tip + "From " + exact_text(parameter.minimum) + " to " + exact_text(parameter.maximum) + unit + ".";
}

bool number_field(FrameContext& frame, const char* name_id, std::string_view name, double& value,
                  const NumberStyle& style)
{
    assert(name_id[0] == '#');  // else Dear ImGui would draw it beside what is typed
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    ImGuiID id = window->GetID(name_id);
    ImVec2 low = window->DC.CursorPos;
    ImRect box(low, {low.x + style.width_px, low.y + frame.theme.row()});
    ImGui::ItemSize(box);
    if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable)) return false;
    bool disabled = GImGui->CurrentItemFlags & ImGuiItemFlags_Disabled;
    bool typing = ImGui::TempInputIsActive(id);
    if (!disabled && !typing) typing = asks_to_type(box, id);
    if (typing) return type(frame, box, name_id, name, value, style);
    bool changed = GImGui->ActiveId == id && drag(frame, id, value, style);
    draw_number(frame, box, id, value, style);
    tooltip(frame, style.tip + "\nDrag, with Shift for small steps; Ctrl+click to type.");
    return changed;
}

bool vector_field(FrameContext& frame, std::string_view path, std::string_view name, float* components, int count,
                  const NumberStyle& style)
{
    static constexpr const char *letters[] = {"x", "y", "z"}, *ids[] = {"##x", "##y", "##z"};
    static constexpr ImU32 tints[] = {colour::rgb(0xe08585), colour::rgb(0x86c58b), colour::rgb(0x82aef0)};
    const Theme& theme = frame.theme;
    float whole_width = style.width_px;
    float width = part_width(theme, count, whole_width);
    bool stacked = vector_is_stacked(theme, count, whole_width);
    bool changed = false;
    ImGui::BeginGroup();
    for (int i = 0; i < count; ++i) {
        NumberStyle part = style;
        part.letter = letters[i];
        part.letter_tint = tints[i];
        part.fill = part.show_unit = stacked;
        part.width_px = stacked ? whole_width : width;
        if (i && !stacked) ImGui::SameLine(0, theme.gap());
        double value = components[i];
        if (number_field(frame, ids[i], std::string(name) + " " + letters[i], value, part)) {
            components[i] = static_cast<float>(value);
            changed = true;
        }
        frame.rects.mark(std::string(path) + "/" + letters[i]);
    }
    ImGui::EndGroup();
    return changed;
}

}  // namespace fieldwright::ui
