// Texts held to the nearest point of their outlines, looked for one by one.
#include "tests/support/fields.h"

#include <gtest/gtest.h>
#include <glm/gtc/constants.hpp>

namespace fieldwright::tests {
namespace {

using glm::dvec2;
using graph::PointList;

// An eight, a ring with a hole, a bar and a star that crosses itself.
PointList shapes()
{
    PointList points = {{-1, -1, 1, 0},   {0, 1, 0, 0},     {-1, 1, 0, 0},      {0, -1, 0, 0},
                        {0.5f, -1, 1, 0}, {2, -1, 0, 0},    {2, 1, 0, 0},       {0.5f, 1, 0, 0},
                        {1, -0.5f, 1, 0}, {1, 0.5f, 0, 0},  {1.5f, 0.5f, 0, 0}, {1.5f, -0.5f, 0, 0},
                        {-2, 0, 1, 0},    {-1.5f, 0, 0, 0}, {-1.5f, 0.1f, 0, 0}};
    for (int i = 0; i < 5; ++i) {
        float angle = 4 * glm::pi<float>() * static_cast<float>(i) / 5;
        points.emplace_back(std::sin(angle), 2.5f + std::cos(angle), i == 0 ? 1.0f : 0.0f, 0.0f);
    }
    return points;
}

double expected(const PointList& points, dvec2 p)
{
    double nearest = 1e9;
    bool inside = false;
    for (std::size_t i = 0, first = 0; i < points.size(); ++i) {
        if (points[i].z > 0.5f) first = i;
        std::size_t next = i + 1 < points.size() && points[i + 1].z < 0.5f ? i + 1 : first;
        dvec2 a(points[i].x, points[i].y), b(points[next].x, points[next].y), along = b - a;
        double share = glm::clamp(glm::dot(p - a, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(p, a + share * along));
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside ? -nearest : nearest;
}

TEST(Text, is_as_far_as_the_nearest_point_of_its_outlines)
{
    constexpr float size = 0.7f;
    Scene scene;
    NodeId text = scene.node("text", {{"outlines", shapes()}, {"size", size}});
    Field field(scene.program({.root = text}));
    Random random(5);
    std::vector<glm::vec3> points;
    for (int i = 0; i < 3000; ++i) points.push_back(random.in_cube(2.5f) * glm::vec3(1, 1, 0));
    std::vector<float> distances = field.at(points);
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_NEAR(distances[i], size * expected(shapes(), dvec2(points[i]) / double(size)), 3e-6)
            << points[i].x << " " << points[i].y;
}

TEST(Text, without_outlines_is_nothing)
{
    Scene scene;
    NodeId text = scene.node("text", {{"outlines", PointList{}}});
    EXPECT_EQ(Field(scene.program({.root = text})).at(std::vector{glm::vec3(0)})[0], 1e6f);
}

}  // namespace
}  // namespace fieldwright::tests
