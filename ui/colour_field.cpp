// The swatch, the hex word and the picker.
#include "ui/colour_field.h"

#include "ui/srgb.h"
#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cstring>

namespace fieldwright::ui {
namespace {

// The picker's own sRGB numbers while they still mean the document's colour: a hue survives grey, and nothing drifts.
glm::vec3 picked_colour(glm::vec3 linear)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    glm::vec3 kept{storage.GetFloat(ImGui::GetID("red"), -1), storage.GetFloat(ImGui::GetID("green"), -1),
                   storage.GetFloat(ImGui::GetID("blue"), -1)};
    return linear_from_srgb(kept) == linear ? kept : srgb_from_linear(linear);
}

void keep_picked(glm::vec3 srgb)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    storage.SetFloat(ImGui::GetID("red"), srgb.x);
    storage.SetFloat(ImGui::GetID("green"), srgb.y);
    storage.SetFloat(ImGui::GetID("blue"), srgb.z);
}

glm::vec3 clamped(glm::vec3 v) { return glm::clamp(v, glm::vec3(0), glm::vec3(1)); }

// Typing is live; what is no colour yet is refused and changes nothing.
bool hex_field(FrameContext& frame, std::string_view name, glm::vec3& linear, float width_px)
{
    std::string before = hex_text(srgb_from_linear(linear));
    char text[16] = {};
    before.copy(text, sizeof text - 1);
    ImGui::PushFont(frame.theme.fonts.mono);
    bool edited;
    {
        RowPadding padding(frame.theme);
        ImGui::SetNextItemWidth(width_px);
        edited = ImGui::InputText("##hex", text, sizeof text, ImGuiInputTextFlags_AutoSelectAll);
    }
    ImGui::PopFont();
    if (!edited || text == before) return false;
    std::optional<glm::vec3> srgb = parse_hex(text);
    if (!srgb) {
        frame.draft.refusal =
            "“" + std::string(text) + "” is not a colour such as #c8503c; " + std::string(name) + " stays as it was";
        return false;
    }
    linear = linear_from_srgb(*srgb);
    return true;
}

bool picker(FrameContext& frame, std::string_view path, std::string_view name, glm::vec3& linear)
{
    glm::vec3 srgb = picked_colour(linear);
    float width = frame.theme.px(220);
    ImGui::SetNextItemWidth(width);
    bool changed = ImGui::ColorPicker3("##picker", &srgb.x,
                                       ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoSidePreview |
                                           ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions);
    frame.rects.mark(std::string(path) + "/picker");
    if (changed) {
        srgb = clamped(srgb);
        linear = linear_from_srgb(srgb);
        keep_picked(srgb);
    }
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImVec2 size(frame.theme.px(40), frame.theme.row());
    ImGui::Dummy(size);
    draw_swatch(frame, linear, low, size);
    ImGui::SameLine(0, frame.theme.gap());
    changed |= hex_field(frame, name, linear, width - size.x - frame.theme.gap());
    frame.rects.mark(std::string(path) + "/picker/hex");
    return changed;
}

}  // namespace

void draw_swatch(const FrameContext& frame, glm::vec3 linear, ImVec2 low, ImVec2 size)
{
    glm::vec3 srgb = clamped(srgb_from_linear(linear));
    ImU32 tint = ImGui::ColorConvertFloat4ToU32({srgb.x, srgb.y, srgb.z, 1});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, tint, frame.theme.px(4));
    draw.AddRect(low, {low.x + size.x, low.y + size.y}, colour::rgb(0xffffff, 28), frame.theme.px(4));
}

bool colour_field(FrameContext& frame, std::string_view path, std::string_view name, glm::vec3& linear, float width_px)
{
    float hex_width = std::min(frame.theme.px(84), 0.6f * width_px);
    ImVec2 low = ImGui::GetCursorScreenPos(), size(width_px - hex_width - frame.theme.gap(), frame.theme.row());
    if (ImGui::InvisibleButton("swatch", size)) ImGui::OpenPopup("picker");
    frame.rects.mark(path);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    tooltip(frame, "Click to pick a colour");
    draw_swatch(frame, linear, low, size);
    ImGui::SameLine(0, frame.theme.gap());
    bool changed = hex_field(frame, name, linear, hex_width);
    frame.rects.mark(std::string(path) + "/hex");
    // Beside the swatch, which shows what is picked.
    ImVec2 window = ImGui::GetMainViewport()->Size, room(frame.theme.px(244), frame.theme.px(252));
    float below = low.y + size.y + frame.theme.gap(), above = low.y - frame.theme.gap() - room.y;
    ImGui::SetNextWindowPos({std::max(std::min(low.x, window.x - room.x), 0.0f),
                             below + room.y < window.y ? below : std::max(above, 0.0f)});
    if (ImGui::BeginPopup("picker")) {
        changed |= picker(frame, path, name, linear);
        ImGui::EndPopup();
    }
    return changed;
}

}  // namespace fieldwright::ui
