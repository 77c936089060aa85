// A primitive that calls itself exact is the distance to its own surface: a sphere of that radius touches it.
#include "tests/support/fields.h"
#include "tests/support/starter.h"

#include <gtest/gtest.h>

namespace fieldwright::tests {
namespace {

using graph::NodeType;
using graph::Quality;

constexpr int direction_count = 3000, start_count = 8, refinement_count = 10;

struct Sphere {
    std::vector<float> at(const std::vector<glm::vec3>& directions) const
    {
        std::vector<glm::vec3> points;
        for (const glm::vec3& direction : directions) points.push_back(centre + radius * direction);
        std::vector<float> values = field.at(points);
        for (float& value : values) value *= side;
        return values;
    }

    const Field& field;
    glm::vec3 centre;
    float radius, side;
};

// The best of some directions that are well apart from each other.
std::vector<glm::vec3> starts(const Sphere& sphere, Random& random)
{
    std::vector<glm::vec3> directions, chosen;
    for (int i = 0; i < direction_count; ++i) directions.push_back(random.direction());
    std::vector<float> values = sphere.at(directions);
    while (chosen.size() < start_count) {
        auto best = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
        chosen.push_back(directions[best]);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (glm::distance(directions[i], chosen.back()) < 0.2f) values[i] = 1e9f;
    }
    return chosen;
}

// The lowest value on the sphere, by directions drawn closer and closer to the best.
float lowest_on(const Sphere& sphere, Random& random)
{
    float lowest = 1e9f;
    for (glm::vec3 best : starts(sphere, random)) {
        float here = sphere.at({best})[0], spread = 0.15f;
        for (int round = 0; round < refinement_count; ++round, spread *= 0.6f) {
            std::vector<glm::vec3> directions;
            for (int i = 0; i < 100; ++i)
                directions.push_back(glm::normalize(best + spread * random.unit() * random.direction()));
            std::vector<float> values = sphere.at(directions);
            auto least = std::min_element(values.begin(), values.end());
            if (*least < here) here = *least, best = directions[static_cast<std::size_t>(least - values.begin())];
        }
        lowest = std::min(lowest, here);
        if (lowest <= 0) break;
    }
    return lowest;
}

// Where a sphere a little larger than the distance does not reach the surface.
std::vector<std::string> overlong_places(const NodeType& type, Quality outside, Quality inside, int number)
{
    Random parameters(static_cast<std::uint64_t>(number) * 977);
    Starter starter(type, graph::Library::embedded(), number == 0 ? nullptr : &parameters);
    Field field(starter.scene.program({.bounds = true, .root = starter.subject}));
    Random random(static_cast<std::uint64_t>(number) + 3);
    std::vector<glm::vec3> points = sample_points(random, 60);
    std::vector<float> distances = field.at(points);
    std::vector<std::string> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if ((distances[i] < 0 ? inside : outside) != Quality::exact) continue;
        float size = std::abs(distances[i]), side = distances[i] < 0 ? -1.0f : 1.0f;
        if (size < 0.01f || size > 6) continue;
        if (lowest_on({field, points[i], 1.004f * size + 0.002f, side}, random) <= 0) continue;
        places.push_back(type.name + " variant " + std::to_string(number) + " at " + std::to_string(points[i].x) + " " +
                         std::to_string(points[i].y) + " " + std::to_string(points[i].z) + ": " +
                         std::to_string(distances[i]));
    }
    return places;
}

TEST(ExactSolids, are_as_far_as_their_surface)
{
    int walked = 0;
    for (const NodeType* type : graph::Library::embedded()->types()) {
        if (type->category != "primitive" || type->quality_outside != Quality::exact) continue;
        for (int number = 0; number < 8; ++number) {
            auto places = overlong_places(*type, type->quality_outside, type->quality_inside, number);
            EXPECT_TRUE(places.empty()) << places.size() << " places, one is " << places.front();
        }
        ++walked;
    }
    EXPECT_GE(walked, 40);
}

TEST(ExactSolids, are_told_apart_from_bounds)
{
    for (const char* name : {"ellipsoid", "superellipsoid"}) {
        const NodeType* type = graph::Library::embedded()->type(name);
        EXPECT_FALSE(overlong_places(*type, Quality::exact, Quality::exact, 0).empty()) << name;
    }
}

}  // namespace
}  // namespace fieldwright::tests
