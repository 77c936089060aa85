// The curve of shaders/nodes/value/curve.glsl.
#include "graph/curve.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::graph {
namespace {

float sign(float x) { return x > 0 ? 1.0f : x < 0 ? -1.0f : 0.0f; }

float slope_between(float chord_before, float width_before, float chord, float width)
{
    float parabola = (chord_before * width + chord * width_before) / (width_before + width);
    float least = std::min({std::abs(chord_before), std::abs(chord), 0.5f * std::abs(parabola)});
    return (sign(chord_before) + sign(chord)) * least;
}

struct Segment {
    float width, chord;
};

Segment between(const glm::vec4& left, const glm::vec4& right)
{
    float width = std::max(right.x - left.x, 1e-9f);
    return {width, (right.y - left.y) / width};
}

}  // namespace

float curve_at(const PointList& points, bool smooth, float x)
{
    PointList sorted(points.begin(),
                     points.begin() + static_cast<std::ptrdiff_t>(std::min(points.size(), curve_point_limit)));
    std::stable_sort(sorted.begin(), sorted.end(), [](const glm::vec4& a, const glm::vec4& b) { return a.x < b.x; });
    auto right =
        std::upper_bound(sorted.begin(), sorted.end(), x, [](float at, const glm::vec4& p) { return at < p.x; });
    if (sorted.empty()) return 0;
    if (right == sorted.begin()) return right->y;
    if (right == sorted.end()) return sorted.back().y;
    auto left = right - 1;
    Segment here = between(*left, *right);
    float t = std::clamp((x - left->x) / here.width, 0.0f, 1.0f), straight = left->y + t * (right->y - left->y);
    if (!smooth) return straight;
    auto first = std::find_if(sorted.begin(), sorted.end(), [&](const glm::vec4& p) { return p.x == left->x; });
    auto after = std::find_if(right, sorted.end(), [&](const glm::vec4& p) { return p.x > right->x; });
    float slope_left = here.chord, slope_right = here.chord;
    if (first != sorted.begin()) {
        Segment before = between(*(first - 1), *left);
        slope_left = slope_between(before.chord, before.width, here.chord, here.width);
    }
    if (after != sorted.end()) {
        Segment next = between(*right, *after);
        slope_right = slope_between(here.chord, here.width, next.chord, next.width);
    }
    float bend = (slope_left - here.chord) * (1 - t) - (slope_right - here.chord) * t;
    return straight + t * (1 - t) * here.width * bend;
}

}  // namespace fieldwright::graph
