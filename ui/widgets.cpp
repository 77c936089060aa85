// Drawing the small things.
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace fieldwright::ui {
namespace {

constexpr float rest_s = 0.45f;  // before a tooltip shows

float label_column(const FrameContext& frame)
{
    float width = ImGui::GetContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    return std::floor(std::clamp(0.30f * width, frame.theme.px(84), frame.theme.px(160)));
}

float row_text_offset(const Theme& theme) { return std::floor(0.5f * (theme.row() - ImGui::GetFontSize())); }

// A plain item that can be hovered, so that it may have a tooltip.
ImRect hoverable(const char* id, ImVec2 size)
{
    ImGui::InvisibleButton(id, ImVec2(std::max(size.x, 1.0f), size.y));
    return {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
}

}  // namespace

const char* category_icon(std::string_view category)
{
    struct Entry {
        std::string_view category;
        const char* icon;
    };
    static constexpr Entry entries[] = {
        {"primitive", icon::cube}, {"combine", icon::cubes},       {"domain", icon::move},
        {"modify", icon::sliders}, {"material", icon::palette},    {"light", icon::bulb},
        {"camera", icon::camera},  {"sky", icon::cloud},           {"output", icon::image},
        {"shape2d", icon::pencil}, {"convert", icon::arrow_right}, {"value", icon::number},
        {"group", icon::cubes},    {"my_groups", icon::cubes}};
    for (const Entry& entry : entries)
        if (entry.category == category) return entry.icon;
    return icon::code;
}

std::string fitted(std::string_view text, float width_px)
{
    const char *begin = text.data(), *end = begin + text.size();
    if (ImGui::CalcTextSize(begin, end).x <= width_px) return std::string(text);
    float room = width_px - ImGui::CalcTextSize("…").x;
    const char* cut = begin;
    if (room > 0) ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), room, 0, begin, end, &cut);
    while (cut > begin && cut[-1] == ' ') --cut;
    return std::string(begin, cut) + "…";
}

void line_text(const FrameContext& frame, std::string_view text, ImU32 tint, float width_px)
{
    float width = width_px > 0 ? width_px : ImGui::GetContentRegionAvail().x;
    std::string shown = fitted(text, width);
    ImGui::PushID(text.data(), text.data() + text.size());
    ImRect box = hoverable("text", {width_px > 0 ? width : ImGui::CalcTextSize(shown.c_str()).x, frame.theme.row()});
    ImGui::PopID();
    ImGui::GetWindowDrawList()->AddText({box.Min.x, box.Min.y + row_text_offset(frame.theme)}, tint, shown.c_str());
    if (shown.size() != text.size() || shown != text) tooltip(frame, text);
}

void paragraph(std::string_view text, ImU32 tint)
{
    ImGui::PushStyleColor(ImGuiCol_Text, tint);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

// Dear ImGui's own clock starts again in every frame for what lies on top of something else.
bool mouse_rests()
{
    ImGuiID clock = ImHashStr("rests", 0, ImGui::GetItemID());  // the item keeps what it remembers under its own id
    float& hovered_s = *ImGui::GetStateStorage()->GetFloatRef(clock, 0);
    hovered_s = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ? hovered_s + ImGui::GetIO().DeltaTime : 0;
    return hovered_s > rest_s;
}

void tooltip(const FrameContext& frame, std::string_view text)
{
    if (!mouse_rests() || text.empty() || ImGui::IsAnyItemActive()) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.theme.px(10), frame.theme.px(8)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(frame.theme.px(320));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

RowPadding::RowPadding(const Theme& theme)
{
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(8), 0.5f * (theme.row() - ImGui::GetFontSize())));
}
RowPadding::~RowPadding() { ImGui::PopStyleVar(); }

bool icon_button(const FrameContext& frame, const char* id, const char* icon, std::string_view tip, ImU32 tint,
                 bool lit)
{
    bool pressed = ImGui::InvisibleButton(id, {frame.theme.row(), frame.theme.row()});
    ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    bool hovered = ImGui::IsItemHovered();
    if (hovered || ImGui::IsItemActive())
        draw.AddRectFilled(box.Min, box.Max, ImGui::GetColorU32(ImGuiCol_ButtonHovered), frame.theme.px(4));
    ImVec2 size = ImGui::CalcTextSize(icon);
    ImU32 shown = lit ? colour::accent : hovered && tint == colour::quiet_text ? colour::text : tint;
    // Through the style's alpha, so that a disabled button looks disabled.
    draw.AddText({std::floor(box.GetCenter().x - 0.5f * size.x), box.Min.y + row_text_offset(frame.theme)},
                 ImGui::GetColorU32(shown), icon);
    tooltip(frame, tip);
    return pressed;
}

bool text_button(const FrameContext& frame, const char* id, std::string_view label, float width_px, ImU32 tint)
{
    float inset = frame.theme.px(10), text_width = ImGui::CalcTextSize(label.data(), label.data() + label.size()).x;
    float width = width_px > 0 ? width_px : std::min(text_width + 2 * inset, ImGui::GetContentRegionAvail().x);
    bool pressed = ImGui::InvisibleButton(id, {std::max(width, frame.theme.row()), frame.theme.row()});
    ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    ImGuiCol ground = ImGui::IsItemActive()    ? ImGuiCol_ButtonActive
                      : ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered
                                               : ImGuiCol_Button;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(box.Min, box.Max, ImGui::GetColorU32(ground), frame.theme.px(4));
    std::string shown = fitted(label, box.GetWidth() - inset);
    float offset = std::max(0.5f * (box.GetWidth() - ImGui::CalcTextSize(shown.c_str()).x), 0.5f * inset);
    draw.AddText({std::floor(box.Min.x + offset), box.Min.y + row_text_offset(frame.theme)}, ImGui::GetColorU32(tint),
                 shown.c_str());
    if (shown != label) tooltip(frame, label);
    return pressed;
}

bool toggle(const FrameContext& frame, const char* id, bool& on)
{
    const Theme& theme = frame.theme;
    bool pressed = ImGui::InvisibleButton(id, {theme.px(34), theme.row()});
    if (pressed) on = !on;
    ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    float height = theme.px(18), radius = 0.5f * height, top = box.GetCenter().y - radius;
    ImU32 ground = on ? ImGui::IsItemHovered() ? colour::rgb(0x5c738f) : colour::rgb(0x4d637e)
                      : ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({box.Min.x, top}, {box.Max.x, top + height}, ground, radius);
    float knob = on ? box.Max.x - radius : box.Min.x + radius;
    draw.AddCircleFilled({knob, top + radius}, radius - theme.px(3), on ? colour::text : colour::quiet_text, 24);
    return pressed;
}

bool segments(FrameContext& frame, std::string_view path, const std::vector<std::pair<std::string, std::string>>& words,
              std::string& chosen)
{
    const Theme& theme = frame.theme;
    auto count = static_cast<float>(words.size());
    float width = std::floor((row_field_width(frame) - (count - 1) * theme.px(1)) / std::max(count, 1.0f));
    bool changed = false;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(1), theme.gap()));
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto& [value, word] = words[i];
        bool active = value == chosen;
        if (i) ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Button, active ? colour::chosen : colour::field);
        if (text_button(frame, value.c_str(), word, width, active ? colour::text : colour::quiet_text) && !active) {
            chosen = value;
            changed = true;
        }
        ImGui::PopStyleColor();
        frame.rects.mark(std::string(path) + "/" + value);
    }
    ImGui::PopStyleVar();
    return changed;
}

bool name_field(const FrameContext& frame, const char* id, std::string& text, const std::string& hint, float width_px)
{
    char buffer[257] = {};
    std::memcpy(buffer, text.data(), std::min(text.size(), sizeof buffer - 1));
    RowPadding padding(frame.theme);
    ImGui::SetNextItemWidth(width_px);
    if (!ImGui::InputTextWithHint(id, hint.c_str(), buffer, sizeof buffer)) return false;
    text = buffer;
    return true;
}

void share_bar(const FrameContext& frame, float share, ImU32 tint)
{
    ImVec2 low = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, frame.theme.px(6));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, colour::field, 0.5f * size.y);
    float filled = size.x * std::clamp(share, 0.0f, 1.0f);
    if (filled > 0) draw.AddRectFilled(low, {low.x + std::max(filled, size.y), low.y + size.y}, tint, 0.5f * size.y);
    ImGui::Dummy(size);
}

void section(const FrameContext& frame, std::string_view title)
{
    ImGui::Dummy({0, 0});
    ImVec2 low = ImGui::GetCursorScreenPos();
    float right = low.x + ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(frame.theme.fonts.heading);
    std::string shown = fitted(title, right - low.x);
    float width = ImGui::CalcTextSize(shown.c_str()).x, middle = std::floor(low.y + 0.5f * frame.theme.row());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText({low.x, low.y + row_text_offset(frame.theme)}, colour::text, shown.c_str());
    ImGui::PopFont();
    if (float from = low.x + width + frame.theme.padding(); from < right)
        draw.AddLine({from, middle + 0.5f}, {right, middle + 0.5f}, colour::line);
    ImGui::Dummy({0, frame.theme.row()});
}

bool folding_section(const FrameContext& frame, const char* title)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    ImGuiID id = ImGui::GetID(title);
    bool open = storage.GetBool(id, true);
    ImGui::Dummy({0, 0});
    if (ImGui::InvisibleButton(title, {std::max(ImGui::GetContentRegionAvail().x, 1.0f), frame.theme.row()}))
        storage.SetBool(id, open = !open);
    ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImU32 tint = ImGui::IsItemHovered() ? colour::text : colour::quiet_text;
    float y = box.Min.y + row_text_offset(frame.theme), x = box.Min.x + frame.theme.px(22);
    draw.AddText({box.Min.x, y}, tint, open ? icon::chevron_down : icon::chevron_right);
    ImGui::PushFont(frame.theme.fonts.heading);
    draw.AddText({x, y}, colour::text, title);
    float from = x + ImGui::CalcTextSize(title).x + frame.theme.padding();
    ImGui::PopFont();
    float middle = std::floor(box.GetCenter().y) + 0.5f;
    draw.AddLine({from, middle}, {box.Max.x, middle}, colour::line);
    return open;
}

void empty_state(const FrameContext& frame, const char* icon, std::string_view sentence)
{
    float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({0, frame.theme.px(12)});
    ImVec2 size = ImGui::CalcTextSize(icon), low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText({low.x + 0.5f * (width - size.x), low.y}, colour::quiet_text, icon);
    ImGui::Dummy({0, size.y + frame.theme.gap()});
    float inset = frame.theme.px(16), wrap = width - 2 * inset;
    ImVec2 text = ImGui::CalcTextSize(sentence.data(), sentence.data() + sentence.size(), false, wrap);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::floor(0.5f * (width - text.x)));
    ImGui::PushStyleColor(ImGuiCol_Text, colour::quiet_text);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + text.x + 1);
    ImGui::TextUnformatted(sentence.data(), sentence.data() + sentence.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::Dummy({0, frame.theme.px(8)});
}

void notice(const FrameContext& frame, const char* icon, ImU32 tint, std::string_view sentence)
{
    const Theme& theme = frame.theme;
    ImVec2 low = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, indent = theme.px(30), inset = theme.px(6);
    ImVec2 text = ImGui::CalcTextSize(sentence.data(), sentence.data() + sentence.size(), false,
                                      std::max(width - indent - inset, 1.0f));
    float height = std::max(text.y + 2 * inset, theme.row());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + width, low.y + height}, colour::with_alpha(tint, 0.13f), theme.px(4));
    draw.AddText({low.x + theme.padding(), low.y + inset}, tint, icon);
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + indent, low.y + inset}, colour::text, sentence.data(),
                 sentence.data() + sentence.size(), std::max(width - indent - inset, 1.0f));
    ImGui::Dummy({width, height});
}

float usual_field_width(const FrameContext& frame)
{
    float width = ImGui::GetContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    return std::max(width - label_column(frame) - frame.theme.padding() - frame.theme.row(), frame.theme.px(24));
}

float row_field_width(const FrameContext& frame)
{
    float end = ImGui::GetContentRegionMax().x - frame.theme.row();
    return std::max(std::floor(end - ImGui::GetCursorPosX()), frame.theme.px(24));
}

float begin_row(const FrameContext& frame, std::string_view label, std::string_view tip)
{
    float column = label_column(frame);
    std::string shown = fitted(label, column);
    ImGui::PushID(label.data(), label.data() + label.size());
    ImRect box = hoverable("label", {column, frame.theme.row()});
    ImGui::PopID();
    float width = ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({std::floor(box.Max.x - width), box.Min.y + row_text_offset(frame.theme)},
                                        ImGui::GetColorU32(colour::rgb(0xa9b2bf)), shown.c_str());
    tooltip(frame,
            shown == label ? std::string(tip) : std::string(label) + (tip.empty() ? "" : "\n") + std::string(tip));
    ImGui::SameLine(0, frame.theme.padding());
    return row_field_width(frame);
}

void to_field_column(const FrameContext& frame)
{
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + label_column(frame) + frame.theme.padding());
}

void to_row_end(const FrameContext& frame)
{
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - frame.theme.row());
}

void fact_row(const FrameContext& frame, std::string_view label, std::string_view text, std::string_view tip)
{
    begin_row(frame, label, tip);
    line_text(frame, text);
}

}  // namespace fieldwright::ui
