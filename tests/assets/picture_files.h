// Picture files made in memory, good and bad.
#pragma once

#include <functional>
#include <string>

namespace fieldwright::tests {

// Pixel (x, y) -> 4 numbers, 0 to 1.
using Painter = std::function<void(int x, int y, float* rgba)>;

// A file of a format by OpenImageIO's name: "png", "jpeg", "hdr", "openexr", "tiff". `channels`: 1 grey, 3 or 4.
std::string encoded_picture(const std::string& format, int width, int height, int channels, const Painter& painter);

// A PNG file of 1 bit a pixel that claims a size and holds next to nothing.
std::string png_bomb(unsigned width, unsigned height);

}  // namespace fieldwright::tests
