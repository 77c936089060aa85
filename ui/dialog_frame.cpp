// Drawing what dialogs have in common.
#include "ui/dialog_frame.h"

#include "ui/keys.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr float button_height_px = 28;

float button_width(const Theme& theme, const char* text)
{
    return std::max(theme.px(88), ImGui::CalcTextSize(text).x + theme.px(24));
}

}  // namespace

bool begin_dialog(const char* name, bool wanted, const Theme& theme, float width_px, float height_px)
{
    if (wanted && !ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    float width = std::min(theme.px(width_px), window.Size.x - theme.px(32));
    float height = std::min(theme.px(height_px), window.Size.y - theme.px(32));
    // A dialog as high as its contents is placed by its top, so that it does not jump once its height is known.
    ImVec2 middle(std::floor(window.Pos.x + window.Size.x / 2), std::floor(window.Pos.y + window.Size.y / 2));
    bool by_contents = height_px == 0;
    ImGui::SetNextWindowPos(by_contents ? ImVec2(middle.x, window.Pos.y + std::floor(window.Size.y / 4)) : middle,
                            ImGuiCond_Always, {0.5f, by_contents ? 0.0f : 0.5f});
    ImGui::SetNextWindowSize({width, by_contents ? 0 : height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(20), theme.px(16)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, theme.px(1));
    bool open = ImGui::BeginPopupModal(name, nullptr,
                                       ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                                           ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);
    if (!open) return false;
    if (!wanted) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
        return false;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(8), theme.px(8)});
    ImGui::PushStyleColor(ImGuiCol_FrameBg, colour::window);
    ImGui::PushStyleColor(ImGuiCol_Button, colour::line);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colour::rgb(0x3f4853));
    return true;
}

void end_dialog()
{
    ImGui::PopStyleColor(3);
    ImGui::PopStyleVar();
    ImGui::EndPopup();
}

void heading(const Theme& theme, const std::string& text)
{
    ImGui::PushFont(theme.fonts.heading);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

int button_row(FrameContext& frame, std::initializer_list<DialogButton> buttons)
{
    const Theme& theme = frame.theme;
    float spacing = ImGui::GetStyle().ItemSpacing.x, width = -spacing;
    for (const DialogButton& button : buttons) width += button_width(theme, button.text) + spacing;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width, 0.0f));
    int clicked = -1, index = 0;
    for (const DialogButton& button : buttons) {
        if (index > 0) ImGui::SameLine();
        int colours = 0;
        if (button.primary) {
            ImGui::PushStyleColor(ImGuiCol_Button, colour::accent);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colour::rgb(0x77b8ff));
            ImGui::PushStyleColor(ImGuiCol_ButtonActive, colour::rgb(0x4a93e6));
            ImGui::PushStyleColor(ImGuiCol_Text, colour::window);
            colours = 4;
        }
        if (ImGui::Button(button.text, {button_width(theme, button.text), theme.px(button_height_px)})) clicked = index;
        ImGui::PopStyleColor(colours);
        frame.rects.mark(button.mark);
        ++index;
    }
    return clicked;
}

bool confirmed_by_key()
{
    return !ImGui::GetIO().WantTextInput && !ImGui::IsWindowAppearing() &&
           (ImGui::IsKeyPressed(key::enter, false) || ImGui::IsKeyPressed(key::keypad_enter, false));
}

bool cancelled_by_key() { return !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(key::escape, false); }

}  // namespace fieldwright::ui
