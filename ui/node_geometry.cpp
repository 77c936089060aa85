// Sizes of nodes, places of their sockets, and curves sampled at 24 points.
#include "ui/node_geometry.h"

#include <algorithm>
#include <cmath>

namespace fieldwright::ui {
namespace {

constexpr int wire_samples = 24;

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b)
{
    glm::vec2 along = b - a;
    float length_squared = glm::dot(along, along);
    float t = length_squared > 0 ? std::clamp(glm::dot(p - a, along) / length_squared, 0.0f, 1.0f) : 0.0f;
    return glm::length(p - a - t * along);
}

float turn(glm::vec2 a, glm::vec2 b, glm::vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool segments_cross(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d)
{
    return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

// Calls `visit(a, b)` for the pieces of a curve until it returns true.
template <typename Visit>
bool any_piece(const WireCurve& curve, const Visit& visit)
{
    glm::vec2 before = curve.points[0];
    for (int i = 1; i <= wire_samples; ++i) {
        glm::vec2 now = curve.at(static_cast<float>(i) / wire_samples);
        if (visit(before, now)) return true;
        before = now;
    }
    return false;
}

}  // namespace

Box box_between(glm::vec2 one, glm::vec2 other) { return {glm::min(one, other), glm::max(one, other)}; }

glm::vec2 node_size(std::size_t input_count)
{
    float rows = static_cast<float>(input_count) * node_row;
    return {node_width, node_header + (input_count ? rows + node_foot : 0)};
}

bool encloses(const std::vector<glm::vec2>& outline, glm::vec2 p)
{
    bool inside = false;
    for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++) {
        glm::vec2 a = outline[before], b = outline[i];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

InputRows::InputRows(const graph::NodeType& type) { hide_behind(0, type); }

InputRows::InputRows(const graph::Node& node, const graph::NodeType* type)
{
    if (!type) {
        first_hidden_ = count_ = node.inputs.size();
        return;
    }
    std::size_t wired = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(type->most_inputs); ++i)
        if (node.input(type->inputs[i].name)) wired = i + 1;
    hide_behind(wired, *type);
}

// Two at least, for a combiner of one shape is none.
void InputRows::hide_behind(std::size_t wired, const graph::NodeType& type)
{
    auto fields = static_cast<std::size_t>(type.most_inputs);
    first_hidden_ = std::min(std::max<std::size_t>(wired + 1, 2), fields);
    hidden_ = fields - first_hidden_;
    count_ = type.inputs.size() - hidden_;
}

glm::vec2 node_size(const graph::NodeType& type) { return node_size(InputRows(type).count()); }

glm::vec2 node_size(const graph::Node& node, const graph::NodeType* type)
{
    return node_size(InputRows(node, type).count());
}

glm::vec2 input_offset(std::size_t row)
{
    return {0, node_header + node_row * (static_cast<float>(row) + 0.5f) + 0.5f * node_foot};
}

glm::vec2 output_offset() { return {node_width, 0.5f * node_header}; }

bool has_output(const graph::NodeType* type)
{
    return !type || (type->output != graph::SocketKind::none && type->output != graph::SocketKind::light &&
                     type->category != "output");
}

Box WireCurve::box() const
{
    Box box{points[0], points[0]};
    for (glm::vec2 p : points) box = box.with({p, p});
    return box;
}

glm::vec2 WireCurve::at(float t) const
{
    float u = 1 - t;
    return u * u * u * points[0] + 3 * u * u * t * points[1] + 3 * u * t * t * points[2] + t * t * t * points[3];
}

WireCurve wire_curve(glm::vec2 output, glm::vec2 input)
{
    glm::vec2 reach{std::max(40.0f, 0.5f * std::abs(input.x - output.x)), 0};
    return {{output, output + reach, input - reach, input}};
}

float distance_to(const WireCurve& curve, glm::vec2 p)
{
    float nearest = glm::length(p - curve.points[0]);
    any_piece(curve, [&](glm::vec2 a, glm::vec2 b) {
        nearest = std::min(nearest, distance_to_segment(p, a, b));
        return false;
    });
    return nearest;
}

bool crosses(const WireCurve& curve, glm::vec2 from, glm::vec2 to)
{
    return curve.box().touches(box_between(from, to)) &&
           any_piece(curve, [&](glm::vec2 a, glm::vec2 b) { return segments_cross(a, b, from, to); });
}

bool passes_through(const WireCurve& curve, const Box& box)
{
    return curve.box().touches(box) &&
           any_piece(curve, [&](glm::vec2 a, glm::vec2 b) { return box.contains(a) || box.contains(b); });
}

}  // namespace fieldwright::ui
