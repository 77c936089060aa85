// A drawing: the filled cells of a square canvas, and the few rectangles a document keeps them as.
#pragma once

#include "graph/value.h"

#include <cstdint>

namespace fieldwright::graph {

// The unit of a list parameter whose entries are rectangles of a drawing, in cells from the lower left corner of the
// canvas: centre x and y, half width, half height. Such a node has an int parameter `cells`, the canvas' side.
inline constexpr const char* drawing_unit = "cells";
inline constexpr int drawing_side_limit = 64;
inline constexpr std::size_t drawing_rectangle_limit = 512;  // what a drawn shape's loop runs over, gaps included

class Drawing {
public:
    explicit Drawing(int side);
    // What the rectangles cover of the canvas, by the cells' centres.
    Drawing(const PointList& rectangles, int side);

    int side() const { return side_; }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_; }
    bool filled(int x, int y) const { return contains(x, y) && cells_[index(x, y)]; }
    void fill(int x, int y, bool on);  // outside the canvas: nothing
    int count() const;                 // of filled cells

    // Few: squares of a quadtree (Finkel, Bentley 1974) with neighbours merged, or runs of rows or columns where those
    // are fewer. They do not overlap.
    PointList rectangles() const;

    bool operator==(const Drawing&) const = default;

private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * side_ + x); }

    int side_;
    std::vector<std::uint8_t> cells_;  // row by row, from below
};

// The rectangles, and after them those that fill the gaps between and around them, with negative half widths: a point
// inside is as deep as the nearest gap is far. Without gaps where all would be more than `drawing_rectangle_limit`.
// Borders are rounded to 1/1024 cell.
PointList with_gaps(const PointList& rectangles);

}  // namespace fieldwright::graph
