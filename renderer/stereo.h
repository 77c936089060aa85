// Stereo modes: the pictures of two eyes as one.
#pragma once

#include "renderer/rows.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fieldwright::renderer {

// In the order of stereo_modes().
enum class Stereo {
    off,
    naive,
    dubois,
    dubois_green_magenta,
    dubois_amber_blue,
    half_colour,
    gray,
    optimised,
    side_by_side,
    top_bottom,
    interlace
};

// Where an anaglyph's colours are mixed: in light, or in the encoded values of a picture file.
enum class StereoSpace { linear, gamma };

// out = left * the left eye's colour + right * the right eye's, clamped; rows red, green, blue of three columns each.
// The red is then raised to `red_power`.
struct EyeMix {
    std::array<float, 9> left{}, right{};
    float red_power = 1;
};

enum class StereoLayout { one_eye, mixed, beside, below, rows };

struct StereoMode {
    const char *name, *title, *help;
    StereoLayout layout;
    EyeMix linear = {}, gamma = {};            // of the layout `mixed`
    unsigned left_glass = 0, right_glass = 0;  // sRGB of the glasses' filters
};

std::span<const StereoMode> stereo_modes();
const StereoMode& mode_of(Stereo stereo);
const EyeMix& mix_of(Stereo stereo, StereoSpace space);
std::optional<Stereo> stereo_from_name(std::string_view name);
const std::vector<std::string>& stereo_names();
std::optional<StereoSpace> stereo_space_from_name(std::string_view name);
const std::vector<std::string>& stereo_space_names();

// Mixes colours of both eyes, `count` of three lanes; `unit` is the value of full light (1, or 255 of bytes).
void mix_eyes(Rows& mixed, int count, const EyeMix& mix, const Rows& left, const Rows& right, float unit);

// Whether a surface of that linear colour is much brighter behind one of the filters than behind the other, so that the
// eyes fight over it (retinal rivalry): more than 25 apart in CIE lightness, each filter's white counting as 100.
bool eyes_fight(Stereo stereo, StereoSpace space, glm::vec3 colour);

}  // namespace fieldwright::renderer
