// A curve through points, as the node `curve` computes it: for drawing it, and for those who test that it is the same.
#pragma once

#include "graph/value.h"

namespace fieldwright::graph {

inline constexpr std::size_t curve_point_limit = 32;  // more do not count

// Smooth: a monotone cubic without overshoot (Steffen 1990); else straight. Level beyond the ends. Points in any order.
float curve_at(const PointList& points, bool smooth, float x);

}  // namespace fieldwright::graph
