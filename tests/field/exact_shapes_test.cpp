// Flat shapes held to the nearest point of their outline, and blends to their reach.
#include "tests/support/fields.h"
#include "tests/support/starter.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using glm::vec2;
using glm::vec3;
using graph::Quality;

std::shared_ptr<const graph::Library> library() { return graph::Library::embedded(); }

Field own_field(const graph::NodeType& type, int number)
{
    Random random(static_cast<std::uint64_t>(number) * 977);
    Starter starter(type, library(), number == 0 ? nullptr : &random);
    return Field(starter.scene.program({.bounds = true, .root = starter.subject}));
}

struct Outline {
    vec2 centre, half;
    float spacing;
    std::vector<vec2> points;
};

// Adds where the sign changes between neighbours of a grid; returns the corners of cells worth a closer look: those that
// the field says are near the outline.
std::vector<vec2> add_crossings(const Field& field, vec2 low, vec2 step, std::size_t count, std::vector<vec2>& outline)
{
    std::vector<vec3> grid;
    for (std::size_t y = 0; y < count; ++y)
        for (std::size_t x = 0; x < count; ++x)
            grid.emplace_back(low + step * vec2(static_cast<float>(x), static_cast<float>(y)), 0.0f);
    std::vector<float> distances = field.at(grid);
    auto crosses = [&](std::size_t here, std::size_t there) {
        if ((distances[here] < 0) == (distances[there] < 0)) return false;
        float share = distances[here] / (distances[here] - distances[there]);
        outline.emplace_back(glm::mix(vec2(grid[here]), vec2(grid[there]), share));
        return true;
    };
    std::vector<vec2> near;
    for (std::size_t y = 0; y + 1 < count; ++y)
        for (std::size_t x = 0; x + 1 < count; ++x) {
            std::size_t i = y * count + x;
            bool across = crosses(i, i + 1), upwards = crosses(i, i + count);
            if (!across && !upwards && std::abs(distances[i]) < 2 * std::max(step.x, step.y))
                near.push_back(vec2(grid[i]));
        }
    return near;
}

// Thin tips lie between the points of the first grid.
Outline outline_of(const Field& field)
{
    constexpr std::size_t count = 400, fine = 9;
    Outline outline;
    for (int axis = 0; axis < 2; ++axis) {
        outline.centre[axis] = field.lane(field.program.bounds, axis);
        outline.half[axis] = 1.05f * std::min(field.lane(field.program.bounds, 3 + axis), 8.0f) + 0.01f;
    }
    vec2 step = 2.0f * outline.half / static_cast<float>(count - 1);
    outline.spacing = std::max(step.x, step.y);
    for (vec2 corner : add_crossings(field, outline.centre - outline.half, step, count, outline.points))
        add_crossings(field, corner, step / static_cast<float>(fine - 1), fine, outline.points);
    return outline;
}

float nearest(const Outline& outline, vec2 p)
{
    float squared = 1e12f;
    for (const vec2& q : outline.points) squared = std::min(squared, glm::dot(p - q, p - q));
    return std::sqrt(squared);
}

// Tips thinner than the finest grid: the field leads from p to a point of the outline that the grid has not seen.
bool leads_to_the_outline(const Field& field, vec3 p, float distance, float within)
{
    constexpr float step = 1e-3f;
    std::vector<vec3> around = {p + vec3(step, 0, 0), p - vec3(step, 0, 0), p + vec3(0, step, 0), p - vec3(0, step, 0)};
    std::vector<float> there = field.at(around);
    vec3 uphill = vec3(there[0] - there[1], there[2] - there[3], 0) / (2 * step);
    return std::abs(field.at(std::vector{p - distance * uphill})[0]) < within;
}

TEST(ExactShapes, give_the_distance_to_the_nearest_point_of_their_outline)
{
    int shapes = 0;
    for (const graph::NodeType* type : library()->types()) {
        if (type->category != "shape2d" || type->quality_outside != Quality::exact) continue;
        ++shapes;
        for (int number = 0; number < 6; ++number) {
            Field field = own_field(*type, number);
            Outline outline = outline_of(field);
            ASSERT_TRUE(number > 0 || outline.points.size() > 200u) << type->name;
            if (outline.points.empty()) continue;
            Random random(static_cast<std::uint64_t>(number));
            std::vector<vec3> points;
            for (int i = 0; i < 300; ++i)
                points.emplace_back(outline.centre + outline.half * vec2(random.in_cube(i % 2 == 0 ? 1.0f : 1.5f)),
                                    0.0f);
            std::vector<float> distances = field.at(points);
            for (std::size_t i = 0; i < points.size(); ++i) {
                bool unbounded = field.lane(field.program.bounds, 3) > 8;
                if (unbounded || (distances[i] < 0 && type->quality_inside != Quality::exact)) continue;
                float expected = nearest(outline, vec2(points[i]));
                float slack = 0.01f * expected + 2 * outline.spacing, found = std::abs(distances[i]);
                if (found < expected - slack && leads_to_the_outline(field, points[i], distances[i], 0.2f * slack))
                    expected = found;
                ASSERT_NEAR(found, expected, slack)
                    << type->name << " variant " << number << " at " << points[i].x << " " << points[i].y;
            }
        }
    }
    EXPECT_GE(shapes, 30);
}

float called(const std::string& function, std::initializer_list<float> values)
{
    std::vector<std::vector<float>> rows;
    std::vector<const float*> arguments;
    for (float value : values) rows.emplace_back(field::row_width, value);
    for (const auto& row : rows) arguments.push_back(row.data());
    std::vector<float> result(field::row_width);
    field::find_kernel(field::kernels(), function)->varying(result.data(), arguments.data(), nullptr, field::row_width);
    return result[0];
}

TEST(Blends, act_only_where_the_distances_differ_by_less_than_their_size)
{
    for (float kernel : {0.0f, 1.0f, 2.0f, 3.0f}) {
        for (float apart : {0.4f, 0.5f, 100.0f, 1e6f}) {
            EXPECT_FLOAT_EQ(called("blended_union_distance", {0.3f, 0.3f + apart, 0.4f, kernel}), 0.3f);
            EXPECT_FLOAT_EQ(called("blended_intersect_distance", {0.3f, 0.3f - apart, 0.4f, kernel}), 0.3f);
            EXPECT_FLOAT_EQ(called("blended_subtract_distance", {0.3f, -0.3f + apart, 0.4f, kernel}), 0.3f);
        }
        EXPECT_LT(called("blended_union_distance", {0.3f, 0.6f, 0.4f, kernel}), 0.3f) << kernel;
        EXPECT_GT(called("blended_intersect_distance", {0.3f, 0.0f, 0.4f, kernel}), 0.3f) << kernel;
        EXPECT_GT(called("blended_subtract_distance", {0.3f, 0.0f, 0.4f, kernel}), 0.3f) << kernel;
        EXPECT_FLOAT_EQ(called("blended_union_distance", {0.3f, 0.4f, 0.0f, kernel}), 0.3f);
    }
}

// A quarter circle of the radius, from one surface to the other.
TEST(Blends, of_a_radius_touch_the_circle_between_two_surfaces_at_right_angles)
{
    float radius = 0.4f;
    for (float angle : {0.1f, 0.5f, 0.8f, 1.4f}) {
        float a = radius - radius * std::cos(angle), b = radius - radius * std::sin(angle);
        EXPECT_NEAR(called("rounded_union_distance", {a, b, radius}), 0, 1e-6f);
        EXPECT_NEAR(called("rounded_intersect_distance", {-a, -b, radius}), 0, 1e-6f);
        EXPECT_NEAR(called("rounded_subtract_distance", {-a, b, radius}), 0, 1e-6f);
    }
}

}  // namespace
}  // namespace fieldwright::tests
