// Arithmetic on intervals: what holds for every number of each argument. Ends may be infinite.
#pragma once

#include "graph/slope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fieldwright::graph {

// Nothing times anything is nothing: an endless slope of what does not change.
inline double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

inline double size(Interval a) { return std::max(std::abs(a.low), std::abs(a.high)); }
inline bool holds(Interval a, double x) { return a.low <= x && x <= a.high; }
inline Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
inline Interval operator+(Interval a, Interval b) { return {a.low + b.low, a.high + b.high}; }
inline Interval operator-(Interval a) { return {-a.high, -a.low}; }

inline Interval operator*(Interval a, Interval b)
{
    double p = times(a.low, b.low), q = times(a.low, b.high), r = times(a.high, b.low), s = times(a.high, b.high);
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

inline Interval square(Interval a)
{
    double low = holds(a, 0) ? 0 : std::min(a.low * a.low, a.high * a.high);
    return {low, std::max(a.low * a.low, a.high * a.high)};
}

inline Interval inverse(Interval a) { return {1 / a.high, 1 / a.low}; }  // of what does not hold 0
template <typename Function>
Interval rising(Interval a, const Function& function)
{
    return {function(a.low), function(a.high)};
}

inline Interval sine(Interval a)
{
    constexpr double turn = 2 * std::numbers::pi;
    if (!(a.high - a.low < turn)) return {-1, 1};
    auto passes = [&](double place) {
        return std::floor((a.high - place) / turn) > std::floor((a.low - place) / turn);
    };
    Interval ends = hull({std::sin(a.low), std::sin(a.low)}, {std::sin(a.high), std::sin(a.high)});
    return {passes(-0.25 * turn) ? -1 : ends.low, passes(0.25 * turn) ? 1 : ends.high};
}

}  // namespace fieldwright::graph
