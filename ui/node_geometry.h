// The geometry of nodes and wires on the canvas, in canvas px (design px at zoom 1): sizes follow from a node's type
// alone, so that layout, hit tests and pictures agree.
#pragma once

#include "graph/document.h"
#include "graph/library.h"

#include <array>
#include <vector>

namespace fieldwright::ui {

inline constexpr float node_width = 180, node_header = 28, node_row = 24, node_foot = 4;

struct Box {
    glm::vec2 low{0, 0}, high{0, 0};
    glm::vec2 size() const { return high - low; }
    glm::vec2 centre() const { return 0.5f * (low + high); }
    bool contains(glm::vec2 p) const { return p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y; }
    bool touches(const Box& other) const
    {
        return low.x <= other.high.x && low.y <= other.high.y && high.x >= other.low.x && high.y >= other.low.y;
    }
    Box grown(float by) const { return {low - by, high + by}; }
    Box with(const Box& other) const { return {glm::min(low, other.low), glm::max(high, other.high)}; }
};
Box box_between(glm::vec2 one, glm::vec2 other);
bool encloses(const std::vector<glm::vec2>& outline, glm::vec2 p);  // closed; even-odd where it crosses itself

// The inputs that a node shows, top to bottom: all of its type, but of a combiner of many only those up to the first
// free one behind the last that is wired. Of a node of unknown type those that are wired.
class InputRows {
public:
    explicit InputRows(const graph::NodeType& type);  // nothing wired
    InputRows(const graph::Node& node, const graph::NodeType* type);
    std::size_t count() const { return count_; }
    std::size_t input(std::size_t row) const
    {
        return row < first_hidden_ ? row : row + hidden_;
    }  // index of the type's

private:
    void hide_behind(std::size_t wired, const graph::NodeType& type);

    std::size_t count_ = 0, first_hidden_ = 0, hidden_ = 0;
};

glm::vec2 node_size(std::size_t input_count);
glm::vec2 node_size(const graph::NodeType& type);
glm::vec2 node_size(const graph::Node& node, const graph::NodeType* type);

// From the node's corner.
glm::vec2 input_offset(std::size_t row);
glm::vec2 output_offset();
// Lights shine without a wire: nothing takes them.
bool has_output(const graph::NodeType* type);

// A cubic Bezier curve from an output to an input.
struct WireCurve {
    std::array<glm::vec2, 4> points;
    Box box() const;  // of its control points: holds the curve
    glm::vec2 at(float t) const;
};
WireCurve wire_curve(glm::vec2 output, glm::vec2 input);
float distance_to(const WireCurve& curve, glm::vec2 p);
bool crosses(const WireCurve& curve, glm::vec2 from, glm::vec2 to);  // a straight stroke
bool passes_through(const WireCurve& curve, const Box& box);

}  // namespace fieldwright::ui
