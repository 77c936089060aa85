#include "ui/font_menu.h"

#include "ui/widgets.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

namespace fieldwright::ui {
namespace {

constexpr const char* popup_name = "fonts";
constexpr const char* built_in = "Inter (always there)";
constexpr float menu_width = 260, menu_height = 320;  // design px

std::string lower(std::string_view text)
{
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::vector<std::string> found(const std::vector<std::string>& families, const std::string& query)
{
    std::vector<std::string> result;
    std::string wanted = lower(query);
    std::copy_if(families.begin(), families.end(), std::back_inserter(result),
                 [&](const std::string& family) { return lower(family).find(wanted) != std::string::npos; });
    return result;
}

// True when Enter was pressed.
bool search(FrameContext& frame, const std::string& path)
{
    if (ImGui::IsWindowAppearing()) frame.focus_next_text();
    ImGui::SetNextItemWidth(-1);
    bool entered = ImGui::InputTextWithHint("##search", "Search fonts", &frame.view.font_query,
                                            ImGuiInputTextFlags_EnterReturnsTrue);
    frame.rects.mark(path + "/search");
    return entered;
}

bool entry(FrameContext& frame, const std::string& path, const std::string& family, const std::string& shown,
           bool is_on)
{
    bool picked = ImGui::Selectable((shown + "##" + family).c_str(), is_on, 0, {0, frame.theme.px(20)});
    frame.rects.mark(path + "/family/" + family);
    return picked;
}

std::optional<std::string> families(FrameContext& frame, const std::string& path, const std::string& chosen)
{
    bool entered = search(frame, path);
    std::vector<std::string> list = found(frame.readings.font_families(), frame.view.font_query);
    if (entered && !list.empty()) return list.front();
    std::optional<std::string> picked;
    ImGui::BeginChild("families");
    if (frame.view.font_query.empty() && entry(frame, path, "", built_in, chosen.empty())) picked = "";
    if (list.empty()) ImGui::TextDisabled("No installed font is called that.");
    ImGuiListClipper clipper;
    for (clipper.Begin(static_cast<int>(list.size())); clipper.Step();)
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string& family = list[static_cast<std::size_t>(i)];
            if (entry(frame, path, family, family, family == chosen)) picked = family;
        }
    ImGui::EndChild();
    return picked;
}

}  // namespace

std::optional<std::string> font_menu(FrameContext& frame, const std::string& path, const std::string& chosen)
{
    if (icon_button(frame, "fonts", icon::chevron_down, "Choose an installed font")) {
        frame.view.font_query.clear();
        ImGui::OpenPopup(popup_name);
    }
    frame.rects.mark(path + "/menu");
    ImGui::SetNextWindowSize({frame.theme.px(menu_width), frame.theme.px(menu_height)});
    if (!ImGui::BeginPopup(popup_name)) return std::nullopt;
    std::optional<std::string> picked = families(frame, path, chosen);
    if (picked) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return picked;
}

}  // namespace fieldwright::ui
