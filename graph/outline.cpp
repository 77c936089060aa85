#include "graph/outline.h"

#include <algorithm>

namespace fieldwright::graph {
namespace {

struct Side {
    glm::vec2 start, end;
};

float cross(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

// How far along the line from start to end the point lies, when it lies on that side.
bool holds(const Side& side, glm::vec2 p)
{
    glm::vec2 along = side.end - side.start, from = p - side.start;
    float length_squared = glm::dot(along, along), share = glm::dot(along, from);
    return cross(along, from) * cross(along, from) <= 1e-10f * length_squared * length_squared && share >= 0 &&
           share <= length_squared;
}

std::optional<glm::vec2> meeting(const Side& a, const Side& b)
{
    for (glm::vec2 end : {b.start, b.end})
        if (holds(a, end)) return end;
    for (glm::vec2 end : {a.start, a.end})
        if (holds(b, end)) return end;
    glm::vec2 along_a = a.end - a.start, along_b = b.end - b.start;
    float turn = cross(along_a, along_b);
    if (turn == 0) return std::nullopt;
    float share_a = cross(b.start - a.start, along_b) / turn, share_b = cross(b.start - a.start, along_a) / turn;
    bool within = share_a >= 0 && share_a <= 1 && share_b >= 0 && share_b <= 1;
    return within ? std::optional(a.start + share_a * along_a) : std::nullopt;
}

// Of two sides, of which the second begins where the first ends.
bool runs_back(const Side& side, const Side& next)
{
    glm::vec2 along = side.end - side.start, onward = next.end - next.start;
    return cross(along, onward) == 0 && glm::dot(along, onward) < 0;
}

// Points that lie on the one before make no side.
std::vector<Side> sides_of_outline(const PointList& outline)
{
    std::vector<glm::vec2> corners;
    for (const glm::vec4& point : outline)
        if (glm::vec2 corner(point); corners.empty() || corners.back() != corner) corners.push_back(corner);
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    std::vector<Side> sides;
    for (std::size_t i = 0; i < corners.size(); ++i) sides.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return sides;
}

}  // namespace

std::optional<glm::vec2> self_contact(const PointList& outline)
{
    std::vector<Side> sides = sides_of_outline(outline);
    std::size_t count = sides.size();
    if (count < 3) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
        if (runs_back(sides[i], sides[(i + 1) % count])) return sides[i].end;
        for (std::size_t k = i + 2; k < count; ++k) {
            bool neighbours = i == 0 && k == count - 1;
            if (auto found = neighbours ? std::nullopt : meeting(sides[i], sides[k])) return found;
        }
    }
    return std::nullopt;
}

}  // namespace fieldwright::graph
