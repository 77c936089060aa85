// A line of text as grey pixels.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace fieldwright::assets {

struct Lettering {
    int width = 0, height = 0;            // px
    std::vector<unsigned char> coverage;  // row by row from the top, 255 = inside a letter
};

// ASCII; `size_px` is the em. The height is the font's, from ascender to descender, whatever the letters.
// graph::Failure{1} when `font` is no font.
Lettering lettering(std::string_view text, int size_px, std::span<const unsigned char> font);

}  // namespace fieldwright::assets
