// Drawing a field that opens a list.
#include "ui/choice_field.h"

#include "ui/widgets.h"

#include <cmath>

namespace fieldwright::ui {
namespace {

// What is chosen, and an arrow, over the frame of a combo.
void draw_combo(const Theme& theme, ImDrawList& draw, ImVec2 low, ImVec2 high, const std::string& shown)
{
    float y = low.y + std::floor(0.5f * (theme.row() - ImGui::GetFontSize()));
    draw.AddText({low.x + theme.px(8), y}, colour::text, fitted(shown, high.x - low.x - theme.px(34)).c_str());
    ImVec2 middle(high.x - theme.px(13), 0.5f * (low.y + high.y) + theme.px(1));
    float arm = theme.px(3.5f);
    ImVec2 arrow[] = {{middle.x - arm, middle.y - 0.5f * arm},
                      {middle.x, middle.y + 0.5f * arm},
                      {middle.x + arm, middle.y - 0.5f * arm}};
    draw.AddPolyline(arrow, 3, colour::quiet_text, 0, theme.px(1.5f));
}

}  // namespace

std::optional<std::size_t> choice_list(FrameContext& frame, std::string_view path, float width_px,
                                       const std::string& shown, std::size_t count, const ChoiceLabel& label)
{
    const Theme& theme = frame.theme;
    ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width_px, low.y + theme.row());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    RowPadding padding(theme);
    ImGui::SetNextItemWidth(width_px);
    ImGui::SetNextWindowSizeConstraints({width_px, 0}, {width_px, theme.px(360)});
    std::string id = "##" + std::string(path);
    bool open = ImGui::BeginCombo(id.c_str(), nullptr, ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
    draw_combo(theme, draw, low, high, shown);
    frame.rects.mark(path, {{low.x, low.y}, {high.x, high.y}});
    if (!open) return std::nullopt;
    std::optional<std::size_t> chosen;
    float room = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < count; ++i) {
        auto [word, text] = label(i);
        if (ImGui::Selectable((fitted(text, room) + "##" + word).c_str(), text == shown, 0, {0, theme.px(20)}))
            chosen = i;
        frame.rects.mark(std::string(path) + "/choice/" + word);
    }
    ImGui::EndCombo();
    return chosen;
}

}  // namespace fieldwright::ui
