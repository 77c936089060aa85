// Colours and words of legends.
#include "ui/legend.h"

#include "ui/number_text.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

// The map's end, and half of it, as numbers.
void set_ends(Legend& legend, double end)
{
    legend.low = "0";
    legend.middle = scale_text(0.5 * end);
    legend.high = scale_text(end);
}

ImU32 mixed(ImU32 a, ImU32 b, float share)
{
    ImVec4 from = ImGui::ColorConvertU32ToFloat4(a), to = ImGui::ColorConvertU32ToFloat4(b);
    return ImGui::ColorConvertFloat4ToU32(
        {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), from.z + share * (to.z - from.z), 1});
}

}  // namespace

std::string scale_text(double number) { return number < 999.5 ? exact_text(number) : rounded_text(number); }

ImU32 map_colour(const ColourMapChoice& map, float share)
{
    if (map.colours.empty()) return colour::quiet_text;
    float x = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(map.colours.size() - 1);
    auto first = std::min(static_cast<std::size_t>(x), map.colours.size() - 1);
    std::size_t second = std::min(first + 1, map.colours.size() - 1);
    return mixed(map.colours[first], map.colours[second], x - static_cast<float>(first));
}

std::optional<Legend> legend_of(const FrameContext& frame, std::string_view name)
{
    const ViewState& view = frame.view;
    Legend legend{.map = find_choice(frame.readings.colour_maps, view.colour_map)};
    if (!legend.map) return std::nullopt;
    if (name == "slice" && view.slice.style == "gradient") {
        legend.title = "Gradient's length away from 1";
        set_ends(legend, 1);
        return legend;
    }
    const ViewChoice* shown = find_choice(frame.readings.views, name);
    if (!shown || shown->scale_title.empty()) return std::nullopt;
    legend.title = shown->scale_title;
    bool of_steps = shown->scale_end == 0;
    int most_steps = view.full_scale > 0 ? view.full_scale : frame.draft.document.march.step_limit;
    set_ends(legend, of_steps ? most_steps : static_cast<double>(shown->scale_end));
    legend.marks_exhausted = name == "steps";
    return legend;
}

float draw_legend_bar(const FrameContext& frame, ImDrawList& list, ImVec2 low, float width_px, const Legend& legend)
{
    const Theme& theme = frame.theme;
    ImFont& font = *theme.fonts.small;
    float height = theme.px(10), y = low.y + height + theme.px(2);
    constexpr int bands = 32;
    for (int i = 0; i < bands; ++i) {
        float from = static_cast<float>(i) / bands, to = static_cast<float>(i + 1) / bands;
        ImU32 left = map_colour(*legend.map, from), right = map_colour(*legend.map, to);
        list.AddRectFilledMultiColor({low.x + from * width_px, low.y}, {low.x + to * width_px, low.y + height}, left,
                                     right, right, left);
    }
    auto write = [&](const std::string& text, float share) {
        float extent = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text.c_str()).x;
        list.AddText(&font, font.FontSize, {std::round(low.x + share * (width_px - extent)), y}, colour::quiet_text,
                     text.c_str());
    };
    write(legend.low, 0), write(legend.middle, 0.5f), write(legend.high, 1);
    return y + font.FontSize - low.y;
}

}  // namespace fieldwright::ui
