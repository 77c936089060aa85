// Closed outlines that meet themselves, and those that do not.
#include "graph/outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fieldwright::graph {
namespace {

PointList outline(std::initializer_list<glm::vec2> corners)
{
    PointList points;
    for (glm::vec2 corner : corners) points.emplace_back(corner, 0.0f, 0.0f);
    return points;
}

TEST(Outline, that_is_simple_meets_itself_nowhere)
{
    EXPECT_FALSE(self_contact({}));
    EXPECT_FALSE(self_contact(outline({{0, 0}, {1, 0}})));
    EXPECT_FALSE(self_contact(outline({{0, 0}, {1, 0}, {0, 1}})));
    EXPECT_FALSE(self_contact(outline({{0, 0}, {2, 0}, {2, 2}, {1, 0.5f}, {0, 2}})));
    EXPECT_FALSE(self_contact(outline({{0, 0}, {1, 0}, {1, 0}, {2, 0}, {1, 1}, {0, 0}})))
        << "doubled and straight corners";
    PointList star;
    for (int i = 0; i < 64; ++i) {
        float angle = 0.0981748f * static_cast<float>(i), radius = i % 2 ? 0.3f : 1.0f;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0f, 0.0f);
    }
    EXPECT_FALSE(self_contact(star));
}

TEST(Outline, that_crosses_itself_says_where)
{
    auto place = self_contact(outline({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 1, 1e-6f);
    EXPECT_NEAR(place->y, 1, 1e-6f);
}

TEST(Outline, that_touches_itself_says_where)
{
    EXPECT_EQ(self_contact(outline({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})), glm::vec2(1, 0)) << "a corner on a side";
    EXPECT_EQ(self_contact(outline({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}})), glm::vec2(1, 1))
        << "two corners";
    EXPECT_EQ(self_contact(outline({{0, 0}, {2, 0}, {1, 0}, {1, 1}})), glm::vec2(2, 0)) << "a side that runs back";
}

}  // namespace
}  // namespace fieldwright::graph
