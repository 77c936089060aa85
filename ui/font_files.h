// The font files built into the program.
#pragma once

#include <span>

namespace fieldwright::ui {

std::span<const unsigned char> inter_regular();
std::span<const unsigned char> inter_semibold();
std::span<const unsigned char> jetbrains_mono();
std::span<const unsigned char> font_awesome();

}  // namespace fieldwright::ui
