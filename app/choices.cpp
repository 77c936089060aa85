// From the renderer's lists to the window's.
#include "app/choices.h"

#include "renderer/colour_map.h"
#include "renderer/slice.h"
#include "renderer/srgb_table.h"
#include "renderer/stereo.h"
#include "renderer/view.h"

#include "graph/words.h"

namespace fieldwright::app {
namespace {

constexpr int map_colours = 65;  // of a legend

ImU32 encoded(glm::vec3 linear)
{
    const renderer::SrgbTable& table = renderer::SrgbTable::shared();
    return IM_COL32(table.byte(linear.r), table.byte(linear.g), table.byte(linear.b), 255);
}

ImU32 opaque(unsigned srgb) { return IM_COL32(srgb >> 16 & 255u, srgb >> 8 & 255u, srgb & 255u, 255); }

ui::StereoChoice stereo_choice(const renderer::StereoMode& mode)
{
    ui::StereoChoice choice{{mode.name, mode.title, mode.help}};
    choice.mixes = mode.layout == renderer::StereoLayout::mixed;
    choice.across = mode.layout == renderer::StereoLayout::beside ? 2 : 1;
    choice.down = mode.layout == renderer::StereoLayout::below ? 2 : 1;
    choice.left_glass = opaque(mode.left_glass);
    choice.right_glass = opaque(mode.right_glass);
    return choice;
}

ui::ColourMapChoice colour_map_choice(const std::string& name)
{
    renderer::ColourMap map = *renderer::colour_map_from_name(name);
    ui::ColourMapChoice choice{{name, graph::in_words(name), std::string(renderer::colour_map_help(map))}};
    for (int i = 0; i < map_colours; ++i)
        choice.colours.push_back(encoded(renderer::map_colour(map, static_cast<float>(i) / (map_colours - 1))));
    return choice;
}

}  // namespace

void fill_choices(ui::Readings& readings)
{
    for (const renderer::ViewKind& kind : renderer::views())
        readings.views.push_back(
            {{kind.name, kind.title, kind.help}, kind.light, kind.scale_title ? kind.scale_title : "", kind.scale_end});
    for (const renderer::StereoMode& mode : renderer::stereo_modes())
        readings.stereo_modes.push_back(stereo_choice(mode));
    for (const std::string& name : renderer::colour_map_names())
        readings.colour_maps.push_back(colour_map_choice(name));
    for (const renderer::SliceStyleKind& style : renderer::slice_styles())
        readings.slice_styles.push_back({style.name, style.title, style.help});
}

}  // namespace fieldwright::app
