// Tables of colour maps. Viridis and inferno: S. van der Walt and N. Smith, 2015. Cividis: J. Nuñez, C. Anderton and
// R. Renslow, 2018. Turbo: A. Mikhailov, 2019.
#include "renderer/colour_map.h"

#include "renderer/srgb_table.h"

#include <algorithm>
#include <array>

namespace fieldwright::renderer {
namespace {

constexpr int places = 17;

struct Table {
    const char *name, *help;
    std::array<unsigned, places> srgb;  // every sixteenth of the map's 256 colours, and the last
};

constexpr Table tables[] = {
    {"viridis",
     "From dark violet over green to yellow: even steps, also without colour vision.",
     {0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c, 0x1fa088, 0x28ae80,
      0x3fbc73, 0x5ec962, 0x84d44b, 0xaddc30, 0xd8e219, 0xfde725}},
    {"inferno",
     "From black over red to pale yellow: even steps, and few things are as dark as little.",
     {0x000004, 0x0b0724, 0x210c4a, 0x3d0965, 0x57106e, 0x71196e, 0x8a226a, 0xa32c61, 0xbc3754, 0xd24644, 0xe45a31,
      0xf1731d, 0xf98e09, 0xfcac11, 0xf9cb35, 0xf2ea69, 0xfcffa4}},
    {"cividis",
     "From blue to yellow: looks nearly the same to people who see fewer colours.",
     {0x00224e, 0x002e6a, 0x1a386f, 0x32436d, 0x434e6c, 0x535a6d, 0x61656f, 0x6f7073, 0x7d7c78, 0x8c8878, 0x9b9476,
      0xaba072, 0xbcae6c, 0xcdbb63, 0xdec958, 0xf0d846, 0xfee838}},
    {"turbo",
     "The rainbow, smoothed: shows the finest differences, but not which of two is more.",
     {0x30123b, 0x4040a2, 0x466be3, 0x4294ff, 0x28bceb, 0x18ddc2, 0x32f298, 0x6dfe62, 0xa4fc3c, 0xcdec34, 0xeecf3a,
      0xfdac34, 0xfb7e21, 0xeb500e, 0xd02f05, 0xa91601, 0x7a0403}},
};

using Colours = std::array<glm::vec3, places>;

Colours decoded(const Table& table)
{
    Colours colours;
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (int k = 0; k < 3; ++k)
            colours[i][k] = SrgbTable::shared().linear(static_cast<unsigned char>(table.srgb[i] >> (16 - 8 * k)));
    return colours;
}

const Colours& colours_of(ColourMap map)
{
    static const std::array<Colours, std::size(tables)> all = [] {
        std::array<Colours, std::size(tables)> decoded_tables;
        std::transform(std::begin(tables), std::end(tables), decoded_tables.begin(), decoded);
        return decoded_tables;
    }();
    return all[static_cast<std::size_t>(map)];
}

}  // namespace

const std::vector<std::string>& colour_map_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Table& table : tables) list.emplace_back(table.name);
        return list;
    }();
    return names;
}

std::optional<ColourMap> colour_map_from_name(std::string_view name)
{
    auto found = std::find_if(std::begin(tables), std::end(tables), [&](const Table& t) { return t.name == name; });
    if (found == std::end(tables)) return std::nullopt;
    return static_cast<ColourMap>(found - std::begin(tables));
}

std::string_view colour_map_help(ColourMap map) { return tables[static_cast<std::size_t>(map)].help; }

glm::vec3 map_colour(ColourMap map, float share)
{
    const Colours& colours = colours_of(map);
    float x = std::clamp(share, 0.0f, 1.0f) * (places - 1);
    auto first = std::min(static_cast<std::size_t>(x), colours.size() - 2);
    return glm::mix(colours[first], colours[first + 1], x - static_cast<float>(first));
}

}  // namespace fieldwright::renderer
