// The line between inside and outside of a grid of numbers, and the distance to it.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace fieldwright::assets {

// Numbers at whole coordinates, row by row from below.
struct NumberGrid {
    int columns = 0, rows = 0;
    std::vector<float> numbers;
    float& at(int x, int y) { return numbers[index(x, y)]; }
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
    }

    float at(int x, int y) const { return numbers[index(x, y)]; }
};

// Where the numbers equal `level`, taken as linear on the four triangles between the corners and the middle of every
// cell. Its segments are exact there; so is which side a point is on.
class ImageOutline {
public:
    // At least 2 x 2 numbers. Inside is where they are greater than the level.
    ImageOutline(const NumberGrid& grid, float level);

    bool empty() const { return segments_.empty(); }
    glm::vec2 low() const { return low_; }  // of its box
    glm::vec2 high() const { return high_; }
    bool inside(glm::vec2 point) const;
    // To the nearest point of the line, unsigned; `bound` is known not to be less.
    float distance(glm::vec2 point, float bound) const;

private:
    struct Segment {
        glm::vec2 from, to;
    };
    struct Level {  // of the pyramid: whether a block of cells holds segments
        int columns = 0, rows = 0;
        std::vector<std::uint8_t> holds;
        bool at(int x, int y) const
        {
            return x < columns && y < rows &&
                   holds[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
        }
    };

    void add_cell(int x, int y);
    void add_triangle(const glm::vec3 (&corners)[3]);
    void build_pyramid();
    void search(std::size_t level, int x, int y, glm::vec2 point, float& squared) const;
    void search_cell(int x, int y, glm::vec2 point, float& squared) const;

    NumberGrid grid_;  // less the level
    std::vector<Segment> segments_;
    std::vector<std::int32_t> first_;  // by cell: its first segment; one more at the end
    std::vector<Level> pyramid_;       // cells first, then blocks of twice the size, up to one
    glm::vec2 low_{0}, high_{0};
};

}  // namespace fieldwright::assets
