// Outlines of a text written in a font: what a text node is drawn from.
#pragma once

#include "graph/value.h"

#include <span>
#include <string>

namespace fieldwright::assets {

struct Writing {
    std::string text;          // UTF-8, lines parted by \n
    std::string font;          // as find_font takes it; empty = the built-in one
    float letter_spacing = 0;  // em, beyond the font's own
    float line_spacing = 1;    // of the font's own
    float alignment = 0.5f;    // of lines of different length: 0 left, 1 right
    auto operator<=>(const Writing&) const = default;
};

struct Outlines {
    graph::PointList contours;  // graph/contours.h: em, centred on the origin, nowhere crossing
    double tolerance = 0;       // em: how far a side may be from the curve it stands for
    std::string problem;        // one sentence when there are none
};

// As fine as fits within graph::contour_side_limit sides, from a thousandth of an em up to a hundredth.
Outlines outlines_of(const Writing& writing, std::span<const unsigned char> built_in_font);

}  // namespace fieldwright::assets
