// Drawn profiles held to the nearest cell, looked for one by one.
#include "graph/drawing.h"
#include "tests/support/fields.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using glm::vec2;
using graph::Drawing;

constexpr float size = 1.6f;  // m

Drawing scribble(Random& random, int side)
{
    Drawing drawing(side);
    for (int i = 0; i < 5; ++i) {
        int x0 = random.below(side), y0 = random.below(side), width = 1 + random.below(side / 2),
            height = 1 + random.below(side / 2);
        bool on = i < 3 || random.chance(0.5f);
        for (int y = y0; y < y0 + height; ++y)
            for (int x = x0; x < x0 + width; ++x) drawing.fill(x, y, on);
    }
    for (int i = 0; i < 6; ++i) drawing.fill(random.below(side), random.below(side), random.chance(0.5f));
    return drawing;
}

// In cells; a ring of empty cells lies around the canvas.
float distance_to_cells(const Drawing& drawing, vec2 at, bool filled)
{
    float nearest = 1e6f;
    for (int y = -1; y <= drawing.side(); ++y)
        for (int x = -1; x <= drawing.side(); ++x) {
            if (drawing.filled(x, y) != filled) continue;
            vec2 beyond = glm::max(glm::abs(at - vec2(x, y) - 0.5f) - 0.5f, vec2(0));
            nearest = std::min(nearest, glm::length(beyond));
        }
    return nearest;
}

float expected_distance(const Drawing& drawing, vec2 p)
{
    float cell = size / static_cast<float>(drawing.side());
    vec2 at = p / cell + 0.5f * static_cast<float>(drawing.side());
    float outside = distance_to_cells(drawing, at, true);
    return cell * (outside > 0 ? outside : -distance_to_cells(drawing, at, false));
}

Field profile(const Drawing& drawing, const graph::PointList& rectangles)
{
    Scene scene;
    NodeId node = scene.node("drawn_profile", {{"rectangles", rectangles}, {"cells", drawing.side()}, {"size", size}});
    return Field(scene.program({.bounds = true, .root = node}));
}

std::vector<glm::vec3> points_on(const Drawing& drawing, Random& random)
{
    std::vector<glm::vec3> points;
    for (int i = 0; i < 400; ++i) points.push_back(random.in_cube(i % 3 ? 0.55f * size : size) * glm::vec3(1, 1, 0));
    // Where rectangles may touch: on the lines between cells.
    for (int i = 0; i < 200; ++i) {
        vec2 line(random.below(drawing.side() + 1), random.below(drawing.side() + 1));
        points.emplace_back((line / static_cast<float>(drawing.side()) - 0.5f) * size, 0.0f);
    }
    return points;
}

TEST(DrawnProfile, is_as_far_as_the_nearest_cell_and_as_deep_as_the_nearest_gap)
{
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        Random random(seed);
        Drawing drawing = scribble(random, 4 + random.below(29));
        if (drawing.count() == 0) continue;
        Field field = profile(drawing, drawing.rectangles());
        std::vector<glm::vec3> points = points_on(drawing, random);
        std::vector<float> distances = field.at(points);
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_NEAR(distances[i], expected_distance(drawing, vec2(points[i])), 3e-6f)
                << seed << " at " << points[i].x << " " << points[i].y;
    }
}

TEST(DrawnProfile, with_too_many_gaps_is_never_deeper_than_it_is)
{
    Drawing board(26);
    for (int y = 0; y < 26; ++y)
        for (int x = 0; x < 26; ++x) board.fill(x, y, (x + y) % 2 == 0);
    graph::PointList rectangles = board.rectangles();
    ASSERT_LE(rectangles.size(), graph::drawing_rectangle_limit);
    ASSERT_EQ(graph::with_gaps(rectangles).size(), rectangles.size());
    Field field = profile(board, rectangles);
    Random random(1);
    std::vector<glm::vec3> points = points_on(board, random);
    std::vector<float> distances = field.at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        float expected = expected_distance(board, vec2(points[i]));
        if (expected > 1e-6f) {
            ASSERT_NEAR(distances[i], expected, 3e-6f);
        } else {
            ASSERT_LE(-distances[i], -expected + 3e-6f);
        }
    }
}

TEST(DrawnProfile, without_a_cell_is_nothing)
{
    EXPECT_EQ(profile(Drawing(16), {}).at(std::vector{glm::vec3(0)})[0], 1e6f);
}

TEST(DrawnProfile, edits_of_cells_change_no_shader_text_but_the_list)
{
    Scene scene;
    NodeId node = scene.node("drawn_profile");
    scene.show(scene.node("extrude", {{"d", node}}));
    graph::Program before = scene.program();
    scene.set(node, "rectangles", graph::PointList{{3, 3, 2, 1}, {8, 9, 1, 4}, {1, 1, 0.5f, 0.5f}});
    graph::Program after = scene.program();
    EXPECT_NE(before.list_data, after.list_data);
    ASSERT_EQ(before.instructions.size(), after.instructions.size());
    for (std::size_t i = 0; i < before.instructions.size(); ++i)
        EXPECT_EQ(before.instructions[i].function, after.instructions[i].function);
}

}  // namespace
}  // namespace fieldwright::tests
