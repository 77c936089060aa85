// The evaluator: every instruction set, blocks, frame values and the reuse of rows.
#include "field/evaluator.h"
#include "graph/edits.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace fieldwright::field {
namespace {

using graph::Document;
using graph::Library;
using graph::NodeId;

class Scene {
public:
    NodeId add(std::string_view type) { return graph::add_node(document, *library, type); }

    NodeId add(std::string_view type, std::initializer_list<std::pair<const char*, NodeId>> inputs)
    {
        NodeId node = add(type);
        for (const auto& [socket, source] : inputs) {
            graph::Refusal refusal = graph::connect(document, *library, source, node, socket);
            EXPECT_FALSE(refusal) << *refusal;
        }
        return node;
    }

    void set(NodeId node, const char* name, graph::Value value)
    {
        graph::Refusal refusal = graph::set_parameter(document, *library, node, name, std::move(value));
        EXPECT_FALSE(refusal) << *refusal;
    }

    std::vector<float> distances_at(const std::vector<glm::vec3>& points, float time = 0, const KernelTable& table = kernels())
    {
        graph::Program program = graph::lower(document, library);
        for (const graph::Problem& problem : program.problems) ADD_FAILURE() << problem.sentence;
        return distances(program, evaluate_frame(program, time), points, table);
    }

    std::shared_ptr<const Library> library = Library::embedded();
    Document document;
};

std::vector<glm::vec3> scattered_points(std::size_t count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-4, 4);
    std::vector<glm::vec3> points(count);
    for (glm::vec3& point : points) point = {coordinate(random), coordinate(random), coordinate(random)};
    return points;
}

TEST(Evaluator, EveryInstructionSetGivesTheSameBytes)
{
    int count = 0;
    const KernelTable* const* tables = runnable_kernels(count);
    std::vector<glm::vec3> points = scattered_points(4096);
    for (const graph::NodeType* type : Library::embedded()->types()) {
        if (type->category != "primitive") continue;
        Scene scene;
        scene.add("output", {{"d", scene.add(type->name)}});
        std::vector<float> widest = scene.distances_at(points, 0, *tables[0]);
        for (int i = 1; i < count; ++i) EXPECT_EQ(scene.distances_at(points, 0, *tables[i]), widest) << type->name;
    }
}

TEST(Evaluator, ABlockFoldsTheNearestCopy)
{
    Scene scene;
    NodeId sphere = scene.add("sphere");
    scene.set(sphere, "radius", 0.5f);
    NodeId repeat = scene.add("repeat", {{"d", sphere}});
    scene.set(repeat, "spacing", glm::vec3(2, 2, 2));
    scene.add("output", {{"d", repeat}});
    std::vector<glm::vec3> points = scattered_points(1000);
    std::vector<float> measured = scene.distances_at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        glm::vec3 nearest = points[i] - 2.0f * glm::floor(points[i] / 2.0f + 0.5f);
        EXPECT_NEAR(measured[i], glm::length(nearest) - 0.5f, 1e-5f);
    }
}

TEST(Evaluator, FrameValuesFollowTime)
{
    Scene scene;
    NodeId time = scene.add("time");
    NodeId sphere = scene.add("sphere", {{"radius", time}});
    scene.add("output", {{"d", sphere}});
    EXPECT_FLOAT_EQ(scene.distances_at({{5, 0, 0}}, 2)[0], 3);
    EXPECT_FLOAT_EQ(scene.distances_at({{5, 0, 0}}, 4)[0], 1);
}

// A wide tree whose branches stay alive while others run: any row reused too early changes the minimum.
TEST(Evaluator, RowsAreReusedOnlyWhenTheirValueIsDead)
{
    Scene scene;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> coordinate(-3, 3);
    std::vector<glm::vec3> centres;
    std::vector<NodeId> roots;
    for (int i = 0; i < 60; ++i) {
        centres.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        NodeId moved = scene.add("translate", {{"d", scene.add("sphere")}});
        scene.set(moved, "offset", centres.back());
        roots.push_back(moved);
    }
    while (roots.size() > 1) {
        NodeId joined = scene.add("smooth_union", {{"a", roots[0]}, {"b", roots.back()}});
        scene.set(joined, "smoothness", 0.0f);
        roots.erase(roots.begin());
        roots.back() = joined;
    }
    scene.add("output", {{"d", roots[0]}});
    std::vector<glm::vec3> points = scattered_points(777);
    std::vector<float> measured = scene.distances_at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        float nearest = 1e9f;
        for (glm::vec3 centre : centres) nearest = std::min(nearest, glm::length(points[i] - centre) - 1);
        EXPECT_NEAR(measured[i], nearest, 2e-5f);
    }
}

}  // namespace
}  // namespace fieldwright::field
