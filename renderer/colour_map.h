// Colour maps: numbers from 0 to 1 as colours that the eye reads as an order.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::renderer {

enum class ColourMap { viridis, inferno, cividis, turbo };

// The enumerators are in the order of their names.
const std::vector<std::string>& colour_map_names();
std::optional<ColourMap> colour_map_from_name(std::string_view name);
std::string_view colour_map_help(ColourMap map);  // what it is good for, one sentence

// Linear Rec.709 of a share, which is clamped to 0 .. 1: between 17 even places, mixed in linear light.
glm::vec3 map_colour(ColourMap map, float share);

}  // namespace fieldwright::renderer
