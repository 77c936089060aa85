// Letters set side by side: the contours of a text, curves as straight sides.
#pragma once

#include "assets/contour_union.h"
#include "assets/outlines.h"

#include <memory>

namespace fieldwright::assets {

// A font's bytes opened by FreeType and HarfBuzz.
class Typesetter {
public:
    // Throws graph::Failure when the bytes are no outline font; they must outlive this.
    Typesetter(std::span<const unsigned char> bytes, int face);
    ~Typesetter();
    Typesetter(const Typesetter&) = delete;
    Typesetter& operator=(const Typesetter&) = delete;

    // In em, centred on the origin: across, the widest line; up, from the last baseline to the capitals of the first
    // line. Curves are left by at most `tolerance`.
    std::vector<Contour> set(const Writing& writing, double tolerance);

private:
    struct Line;
    struct Handles;
    Line shaped(const std::string& text, double letter_spacing) const;
    void add_line(const Line& line, glm::dvec2 origin, double tolerance, std::vector<Contour>& into) const;

    std::unique_ptr<Handles> handles_;
    double units_ = 1000;  // of the font per em
};

}  // namespace fieldwright::assets
