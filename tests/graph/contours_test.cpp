// Contours and their sides.
#include "graph/contours.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::PointList;

TEST(Contours, are_closed_each_for_itself)
{
    PointList sides = graph::sides_of({{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {5, 5, 1, 0}, {6, 5, 0, 0}});
    PointList expected = {{0, 0, 1, 0}, {1, 0, 0, 1}, {0, 1, 0, 0}, {5, 5, 6, 5}, {6, 5, 5, 5}};
    EXPECT_EQ(sides, expected);
    EXPECT_TRUE(graph::sides_of({}).empty());
}

TEST(Contours, begin_with_the_first_point_whether_marked_or_not)
{
    PointList expected = {{1, 2, 3, 4}, {3, 4, 1, 2}};
    EXPECT_EQ(graph::sides_of({{1, 2, 0, 0}, {3, 4, 0, 0}}), expected);
}

TEST(Contours, beyond_the_limit_are_left_out_whole_and_noted)
{
    PointList points;
    for (int contour = 0; contour < 3; ++contour)
        for (int i = 0; i < 200; ++i)
            points.emplace_back(static_cast<float>(i), static_cast<float>(contour), i == 0 ? 1.0f : 0.0f, 0.0f);
    EXPECT_EQ(graph::sides_of(points).size(), 400u);
    Scene scene;
    NodeId text = scene.node("text", {{"outlines", points}});
    scene.show(scene.node("extrude", {{"d", text}}));
    graph::Program program = scene.program();
    ASSERT_EQ(program.problems.size(), 1u);
    EXPECT_EQ(program.problems[0].node, text);
    EXPECT_EQ(program.problems[0].sentence, "its outlines have 600 sides; of these, 400 are drawn");
}

}  // namespace
}  // namespace fieldwright::tests
