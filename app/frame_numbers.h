// Frames of an animation and parts of a picture, as the command line writes them.
#pragma once

#include "renderer/frame.h"

#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::app {

// "1-10,20,30-40x2", with .. as good as -: the numbers in the order given. Nothing when it does not read so, or when
// there are more than a million.
std::optional<std::vector<int>> frames_from_text(std::string_view text);

// The last run of # becomes the number, with zeros before it up to the run's length: out.####.png, 7 -> out.0007.png.
std::string numbered(const std::string& name, int frame);
bool has_number_place(const std::string& name);

// "X,Y,WIDTH,HEIGHT" in pixels from the top left, or "N/M": the Nth of M bands from the top. Nothing when it does not read
// so or reaches beyond the picture.
std::optional<renderer::Area> tile_from_text(std::string_view text, int width, int height);

}  // namespace fieldwright::app
