// The node types that the editor itself reaches for; everything else is known by category and sockets alone.
#pragma once

#include <string_view>

namespace fieldwright::graph::known_types {

inline constexpr std::string_view output = "output";
inline constexpr std::string_view union_of_two = "union";
inline constexpr std::string_view translate = "translate";
inline constexpr std::string_view translate_offset = "offset";  // its parameter
inline constexpr std::string_view extrude = "extrude";
inline constexpr std::string_view polygon = "polygon";
inline constexpr std::string_view three_extrusions = "three_extrusions";
inline constexpr std::string_view paint = "paint";
inline constexpr std::string_view curve = "curve";
inline constexpr std::string_view curve_style = "style";  // its parameters
inline constexpr std::string_view curve_place = "x";
inline constexpr std::string_view perspective = "perspective";
inline constexpr std::string_view orthographic = "orthographic";
inline constexpr std::string_view camera_position = "position";  // parameters of both cameras
inline constexpr std::string_view camera_target = "target";
inline constexpr std::string_view field_of_view = "field_of_view";  // of the perspective one, degrees
inline constexpr std::string_view view_height = "height";           // of the orthographic one, m
inline constexpr std::string_view sun = "sun";
inline constexpr std::string_view sun_elevation = "elevation";  // degrees above the horizon
inline constexpr std::string_view sun_azimuth = "azimuth";      // degrees about +y, 0 is +z
inline constexpr std::string_view sun_and_sky = "sun_and_sky";  // has the sun's angles too
inline constexpr std::string_view light_shadow = "shadow";
inline constexpr std::string_view light_position = "position";    // of lamps
inline constexpr std::string_view light_target = "target";        // of spots
inline constexpr std::string_view light_intensity = "intensity";  // of lamps, at 1 m

}  // namespace fieldwright::graph::known_types
