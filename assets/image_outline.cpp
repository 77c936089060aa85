// Segments by triangle, and a search that leaves out what is farther than the best so far.
#include "assets/image_outline.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::assets {
namespace {

float squared_distance(glm::vec2 point, glm::vec2 from, glm::vec2 to)
{
    glm::vec2 along = to - from, start = point - from;
    float length = glm::dot(along, along);
    float share = length > 0 ? std::clamp(glm::dot(start, along) / length, 0.0f, 1.0f) : 0.0f;
    glm::vec2 away = start - share * along;
    return glm::dot(away, away);
}

float squared_distance_to_block(glm::vec2 point, glm::vec2 low, float size)
{
    glm::vec2 away = point - glm::clamp(point, low, low + size);
    return glm::dot(away, away);
}

}  // namespace

ImageOutline::ImageOutline(const NumberGrid& grid, float level) : grid_(grid), low_(1e9f), high_(-1e9f)
{
    for (float& number : grid_.numbers) number -= level;
    for (int y = 0; y + 1 < grid_.rows; ++y)
        for (int x = 0; x + 1 < grid_.columns; ++x) add_cell(x, y);
    first_.push_back(static_cast<std::int32_t>(segments_.size()));
    for (const Segment& segment : segments_) {
        low_ = glm::min(low_, glm::min(segment.from, segment.to));
        high_ = glm::max(high_, glm::max(segment.from, segment.to));
    }
    build_pyramid();
}

void ImageOutline::add_cell(int x, int y)
{
    first_.push_back(static_cast<std::int32_t>(segments_.size()));
    auto corner = [&](int dx, int dy) { return glm::vec3(x + dx, y + dy, grid_.at(x + dx, y + dy)); };
    glm::vec3 corners[4] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    glm::vec3 middle = 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
    for (int i = 0; i < 4; ++i) add_triangle({corners[i], corners[(i + 1) % 4], middle});
}

// Between the sides of the corner that is alone on its side.
void ImageOutline::add_triangle(const glm::vec3 (&corners)[3])
{
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 &alone = corners[i], &next = corners[(i + 1) % 3], &last = corners[(i + 2) % 3];
        bool inside = alone.z > 0;
        if (inside == (next.z > 0) || inside == (last.z > 0)) continue;
        auto crossing = [&](const glm::vec3& other) {
            return glm::vec2(alone) + (glm::vec2(other) - glm::vec2(alone)) * (alone.z / (alone.z - other.z));
        };
        segments_.push_back({crossing(next), crossing(last)});
    }
}

void ImageOutline::build_pyramid()
{
    Level cells{grid_.columns - 1, grid_.rows - 1, {}};
    for (std::size_t i = 0; i + 1 < first_.size(); ++i) cells.holds.push_back(first_[i] < first_[i + 1]);
    pyramid_.push_back(std::move(cells));
    while (pyramid_.back().columns > 1 || pyramid_.back().rows > 1) {
        const Level& finer = pyramid_.back();
        Level coarser{(finer.columns + 1) / 2, (finer.rows + 1) / 2, {}};
        for (int y = 0; y < coarser.rows; ++y)
            for (int x = 0; x < coarser.columns; ++x)
                coarser.holds.push_back(finer.at(2 * x, 2 * y) || finer.at(2 * x + 1, 2 * y) ||
                                        finer.at(2 * x, 2 * y + 1) || finer.at(2 * x + 1, 2 * y + 1));
        pyramid_.push_back(std::move(coarser));
    }
}

bool ImageOutline::inside(glm::vec2 point) const
{
    glm::vec2 last(grid_.columns - 1, grid_.rows - 1);
    point = glm::clamp(point, glm::vec2(0), last);
    glm::vec2 cell = glm::min(glm::floor(point), last - 1.0f);
    int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
    glm::vec2 share = point - cell;
    float a = grid_.at(x, y), b = grid_.at(x + 1, y), c = grid_.at(x + 1, y + 1), d = grid_.at(x, y + 1);
    float middle = 0.25f * (a + b + c + d);
    // The triangle by its outer side; then linear along that side and towards the middle.
    glm::vec2 off = share - 0.5f;
    bool level_side = std::abs(off.x) <= std::abs(off.y);
    float outward = level_side ? std::abs(off.y) : std::abs(off.x);
    if (outward <= 0) return middle > 0;
    float from = level_side ? (off.y < 0 ? a : d) : (off.x < 0 ? a : b);
    float to = level_side ? (off.y < 0 ? b : c) : (off.x < 0 ? d : c);
    float along = 0.5f + 0.5f * (level_side ? off.x : off.y) / outward;
    float at_side = from + (to - from) * along;
    return middle + (at_side - middle) * 2 * outward > 0;
}

float ImageOutline::distance(glm::vec2 point, float bound) const
{
    float squared = bound * bound;
    search(pyramid_.size() - 1, 0, 0, point, squared);
    return std::sqrt(squared);
}

void ImageOutline::search(std::size_t level, int x, int y, glm::vec2 point, float& squared) const
{
    if (!pyramid_[level].at(x, y)) return;
    auto size = static_cast<float>(1 << level);
    if (squared_distance_to_block(point, size * glm::vec2(x, y), size) >= squared) return;
    if (level == 0) return search_cell(x, y, point, squared);
    // The quarter nearest to the point first: most of the others are then farther than what it holds.
    glm::vec2 middle = size * (glm::vec2(x, y) + 0.5f);
    int near_x = point.x >= middle.x, near_y = point.y >= middle.y;
    for (auto [dx, dy] : {std::pair(near_x, near_y), std::pair(1 - near_x, near_y), std::pair(near_x, 1 - near_y),
                          std::pair(1 - near_x, 1 - near_y)})
        search(level - 1, 2 * x + dx, 2 * y + dy, point, squared);
}

void ImageOutline::search_cell(int x, int y, glm::vec2 point, float& squared) const
{
    std::size_t cell =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.columns - 1) + static_cast<std::size_t>(x);
    for (std::int32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
        const Segment& segment = segments_[static_cast<std::size_t>(i)];
        squared = std::min(squared, squared_distance(point, segment.from, segment.to));
    }
}

}  // namespace fieldwright::assets
