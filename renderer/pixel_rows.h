// Rows of some of a tile's pixels, and the pool of all of them.
#pragma once

#include "renderer/cpu_marcher.h"

#include <algorithm>

namespace fieldwright::renderer {

inline int size(Pixels pixels) { return static_cast<int>(pixels.size()); }

// Lanes of a pool's pixels into a row, side by side.
void gather(Rows& to, int to_lane, const Rows& pool, int pool_lane, int lanes, Pixels pixels);
Rows gathered(const Rows& pool, int first_lane, int lanes, Pixels pixels);
Rows gathered(const Rows& pool, Pixels pixels);
void scatter(Rows& pool, int pool_lane, const Rows& from, int from_lane, int lanes, Pixels pixels);
// The pool's pixels take a share of their lanes from a row. share: a pool of one lane.
void mix_in(Rows& pool, int pool_lane, const Rows& from, int lanes, const Rows& share, Pixels pixels);

// Lanes of the first `count` of a row into another.
void copy_lanes(Rows& to, int to_lane, const Rows& from, int from_lane, int lanes, int count);

// visit(pixels): as many at once as a row holds.
template <typename Visit>
void for_batches(Pixels pixels, Visit visit)
{
    constexpr auto most = static_cast<std::size_t>(field::row_width);
    for (std::size_t first = 0; first < pixels.size(); first += most)
        visit(pixels.subspan(first, std::min(most, pixels.size() - first)));
}

}  // namespace fieldwright::renderer
